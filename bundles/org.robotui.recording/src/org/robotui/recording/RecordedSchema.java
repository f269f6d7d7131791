package org.robotui.recording;

import java.util.Arrays;

/**
 * The type of messages, with its definition. Equal where name, encoding and definition are.
 */
public final class RecordedSchema {

  /** For messages whose type is not known. */
  public static final RecordedSchema NONE = new RecordedSchema("", "", new byte[0]);

  private final String name;
  private final String encoding;
  private final byte[] definition;

  /**
   * A type.
   *
   * @param name such as {@code sensor_msgs/msg/Imu}
   * @param encoding how the definition is written: {@code ros1msg}, {@code ros2msg}, {@code protobuf},
   * {@code jsonschema}, or any other word; empty for none
   * @param definition copied
   */
  public RecordedSchema(String name, String encoding, byte[] definition) {
    this.name = name;
    this.encoding = encoding;
    this.definition = definition.clone();
  }

  /**
   * What the type is called.
   *
   * @return the name; empty where there is no schema
   */
  public String name() {
    return name;
  }

  /**
   * How the definition is written.
   *
   * @return the word of the file; empty where there is no schema
   */
  public String encoding() {
    return encoding;
  }

  /**
   * The definition.
   *
   * @return a copy
   */
  public byte[] definition() {
    return definition.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RecordedSchema schema && name.equals(schema.name) && encoding.equals(schema.encoding)
        && Arrays.equals(definition, schema.definition);
  }

  @Override
  public int hashCode() {
    return 31 * name.hashCode() + Arrays.hashCode(definition);
  }

  @Override
  public String toString() {
    return "schema " + name + " (" + encoding + ", " + definition.length + " bytes)";
  }
}
