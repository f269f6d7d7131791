package org.robotui.roblets.tree;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** How a record is called as a message, and what it means to who does not know it. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface BodyMessage {
  /**
   * The name of its element.
   *
   * @return empty for that of the record, with a small letter first
   */
  String value() default "";

  /**
   * What it is: {@code gpsfix}, {@code heading}, {@code pose}, {@code odometry}, {@code velocity}, {@code battery}.
   *
   * @return empty where it is none of these
   */
  String as() default "";
}
