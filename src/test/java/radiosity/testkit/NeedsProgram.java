package radiosity.testkit;

import java.io.File;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/**
 * A test that needs a program of the system. Without the program a class is reported as one skipped test with its
 * reason; a class whose preparation is broken off by an assumption would be reported as no test at all.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(NeedsProgram.Condition.class)
public @interface NeedsProgram {

    /** File names of programs of which one is enough, in a directory of PATH. */
    String[] value();

    /** Looks whether one of the programs is there. */
    final class Condition implements ExecutionCondition {

        @Override
        public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
            return AnnotationSupport.findAnnotation(context.getElement(), NeedsProgram.class)
                    .map(needed -> find(needed.value()))
                    .orElseGet(() -> ConditionEvaluationResult.enabled("needs no program"));
        }

        private static ConditionEvaluationResult find(String... names) {
            String all = String.join(" or ", names);
            return Stream.of(names).anyMatch(Condition::isInstalled) ? ConditionEvaluationResult.enabled(all)
                    : ConditionEvaluationResult.disabled("needs " + all + ", which is not installed");
        }

        private static boolean isInstalled(String name) {
            return Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
                    .anyMatch(directory -> Files.isExecutable(Path.of(directory, name)));
        }
    }
}
