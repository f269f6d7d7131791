package org.robotui.roblets.roblet;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** How a roblet is called, how often it runs, and with whom it speaks without the brain. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface RobletInfo {
  /**
   * The name, one of its kind in a body.
   *
   * @return empty for that of the class, with a small letter first and without {@code Roblet} at its end
   */
  String name() default "";

  /**
   * How often it runs.
   *
   * @return Hz
   */
  double frequency();

  /**
   * Roblets to which it may speak directly.
   *
   * @return their names
   */
  String[] friends() default {};
}
