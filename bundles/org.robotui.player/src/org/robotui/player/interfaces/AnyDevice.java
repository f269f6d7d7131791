package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** What every device may understand. */
public final class AnyDevice {

  /** Request: capability by {@link Capability}; the answer is empty. Does the device know this message? */
  public static final Kind.Request<Capability, Empty> CAPABILITY =
      new Kind.Request<>("any", "capability", Capability.class, Empty.class);

  /** Request: get int property with {@link IntProperty}; answered by {@link IntProperty}. */
  public static final Kind.Request<IntProperty, IntProperty> GET_INT_PROPERTY =
      new Kind.Request<>("any", "get_int_property", IntProperty.class, IntProperty.class);

  /** Request: set int property by {@link IntProperty}; the answer is empty. */
  public static final Kind.Request<IntProperty, Empty> SET_INT_PROPERTY =
      new Kind.Request<>("any", "set_int_property", IntProperty.class, Empty.class);

  /** Request: get double property with {@link DoubleProperty}; answered by {@link DoubleProperty}. */
  public static final Kind.Request<DoubleProperty, DoubleProperty> GET_DOUBLE_PROPERTY =
      new Kind.Request<>("any", "get_double_property", DoubleProperty.class, DoubleProperty.class);

  /** Request: set double property by {@link DoubleProperty}; the answer is empty. */
  public static final Kind.Request<DoubleProperty, Empty> SET_DOUBLE_PROPERTY =
      new Kind.Request<>("any", "set_double_property", DoubleProperty.class, Empty.class);

  /** Request: get string property with {@link StringProperty}; answered by {@link StringProperty}. */
  public static final Kind.Request<StringProperty, StringProperty> GET_STRING_PROPERTY =
      new Kind.Request<>("any", "get_string_property", StringProperty.class, StringProperty.class);

  /** Request: set string property by {@link StringProperty}; the answer is empty. */
  public static final Kind.Request<StringProperty, Empty> SET_STRING_PROPERTY =
      new Kind.Request<>("any", "set_string_property", StringProperty.class, Empty.class);

  /** Request: get bool property with {@link BoolProperty}; answered by {@link BoolProperty}. */
  public static final Kind.Request<BoolProperty, BoolProperty> GET_BOOL_PROPERTY =
      new Kind.Request<>("any", "get_bool_property", BoolProperty.class, BoolProperty.class);

  /** Request: set bool property by {@link BoolProperty}; the answer is empty. */
  public static final Kind.Request<BoolProperty, Empty> SET_BOOL_PROPERTY =
      new Kind.Request<>("any", "set_bool_property", BoolProperty.class, Empty.class);

  private AnyDevice() {}

  /**
   * A message that a device may know.
   *
   * @param type the type of the message by its number on the wire
   * @param subtype the message
   */
  public record Capability(long type, long subtype) {}

  /**
   * A setting of a device that is a whole number.
   *
   * @param key its name
   * @param value its value; anything in questions
   */
  public record IntProperty(String key, int value) {}

  /**
   * A setting of a device that is a real number.
   *
   * @param key its name
   * @param value its value; anything in questions
   */
  public record DoubleProperty(String key, double value) {}

  /**
   * A setting of a device that is a text.
   *
   * @param key its name
   * @param value its value; empty in questions
   */
  public record StringProperty(String key, String value) {}

  /**
   * A setting of a device that is on or off.
   *
   * @param key its name
   * @param value its value; anything in questions
   */
  public record BoolProperty(String key, boolean value) {}
}
