package org.robotui.message;

import java.util.Objects;

/**
 * How the fields of messages become bytes. A binding calls the methods of these two classes directly, so that the
 * virtual machine compiles it for one encoding as it would a codec that is written by hand.
 *
 * @param reader the public class that reads
 * @param writer the public class that writes
 */
public record Encoding(Class<? extends FieldReader> reader, Class<? extends FieldWriter> writer) {

  /** The serialization of ROS 1: little endian, without padding. */
  public static final Encoding ROS1 = new Encoding(MessageReader.class, MessageWriter.class);

  /** Checks that nothing is missing. */
  public Encoding {
    Objects.requireNonNull(reader, "reader");
    Objects.requireNonNull(writer, "writer");
  }
}
