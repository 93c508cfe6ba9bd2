package radiosity.rmi;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.Collections;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import radiosity.scene.SceneFormatException;

/**
 * The key by which master and hosts know each other ({@code -key}): a PKCS12 file with one key and its own certificate,
 * as {@code scripts/make-key} makes it. Programs without the same file are refused and cannot read the messages.
 */
public final class HostKey {

    /** Password of the file, as keytool requires one; the secret is the file itself, not the password. */
    private static final char[] PASSWORD = "radiosity".toCharArray();

    private final SSLContext context;

    private HostKey(SSLContext context) {
        this.context = context;
    }

    /** @throws IOException where the file cannot be read or holds no key */
    public static HostKey read(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            KeyStore keys = KeyStore.getInstance("PKCS12");
            keys.load(in, PASSWORD);
            return new HostKey(context(keys, trusted(file, keys)));
        } catch (java.nio.file.FileSystemException e) {
            throw e;
        } catch (GeneralSecurityException | IOException e) {
            throw noKey(file, e.getMessage() == null ? "another file" : e.getMessage());
        }
    }

    private static SceneFormatException noKey(Path file, String got) {
        return new SceneFormatException(file.toString(), "", "a key that scripts/make-key has made", got);
    }

    private static KeyStore trusted(Path file, KeyStore keys) throws GeneralSecurityException, IOException {
        KeyStore trusted = KeyStore.getInstance("PKCS12");
        trusted.load(null, null);
        for (String alias : Collections.list(keys.aliases())) {
            trusted.setCertificateEntry(alias, keys.getCertificate(alias));
        }
        if (trusted.size() == 0) {
            throw noKey(file, "a file without any");
        }
        return trusted;
    }

    private static SSLContext context(KeyStore keys, KeyStore trusted) throws GeneralSecurityException {
        KeyManagerFactory own = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        own.init(keys, PASSWORD);
        TrustManagerFactory others = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        others.init(trusted);
        SSLContext context = SSLContext.getInstance("TLSv1.3");
        context.init(own.getKeyManagers(), others.getTrustManagers(), null);
        return context;
    }

    SSLContext context() {
        return context;
    }
}
