package org.robotui.roblets.roblet;

import java.lang.annotation.ElementType;
import java.lang.annotation.Repeatable;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** What a roblet says. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
@Repeatable(OutputMessage.Several.class)
public @interface OutputMessage {
  /**
   * The record of the message.
   *
   * @return the record
   */
  Class<? extends Record> value();

  /** More than one. */
  @Retention(RetentionPolicy.RUNTIME)
  @Target(ElementType.TYPE)
  @interface Several {
    /**
     * All of them.
     *
     * @return in their order
     */
    OutputMessage[] value();
  }
}
