package org.robotui.data;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Declares how a data type is delivered. A type without it takes the declaration of the type that it extends. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Delivery {
  /**
   * What becomes of values not yet taken.
   *
   * @return the conflation
   */
  Conflation conflation() default Conflation.SAMPLE;

  /**
   * What late consumers get.
   *
   * @return the rule
   */
  Late late() default Late.LAST;

  /**
   * Whether a value loses its worth with age. A map is true until the next one; a scan is not.
   *
   * @return true where an old value is shown as stale
   */
  boolean expires() default true;
}
