package radiosity.testkit;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/**
 * A test whose cases are made of reference data beside the repository. Without them it is reported as one skipped test
 * with its reason; a source of cases that is empty would be reported as no test at all.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(NeedsReference.Condition.class)
public @interface NeedsReference {

    /** Path of the data below the folder of references. */
    String value();

    /** Looks whether the data are there. */
    final class Condition implements ExecutionCondition {

        @Override
        public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
            return AnnotationSupport.findAnnotation(context.getElement(), NeedsReference.class)
                    .map(needed -> find(Path.of("..", "shared").resolve(needed.value())))
                    .orElseGet(() -> ConditionEvaluationResult.enabled("needs no reference data"));
        }

        private static ConditionEvaluationResult find(Path data) {
            return Files.exists(data) ? ConditionEvaluationResult.enabled(data + " is there")
                    : ConditionEvaluationResult.disabled("no reference data: " + data + " is not there");
        }
    }
}
