package org.robotui.roblets.tree;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** The unit of a number of a message, for who reads its description. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface BodyUnit {
  /**
   * The unit.
   *
   * @return such as {@code m/s} or {@code deg}
   */
  String value();
}
