package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * How the fields of messages become bytes. A binding calls the methods of the two classes directly, so that the virtual
 * machine compiles it for one encoding as it would a codec that is written by hand.
 *
 * @param readerType the public class that reads
 * @param writerType the public class that writes
 * @param opener makes what reads a message
 * @param maker makes what writes one
 */
public record Encoding(Class<? extends FieldReader> readerType, Class<? extends FieldWriter> writerType, Opener opener,
    Supplier<? extends FieldWriter> maker) {

  /** The serialization of ROS 1: little endian, without padding. */
  public static final Encoding ROS1 =
      new Encoding(MessageReader.class, MessageWriter.class, MessageReader::new, MessageWriter::new);

  /** The encoding of ROS 2: CDR, version 1, with encapsulation; read in either byte order, written little endian. */
  public static final Encoding CDR = new Encoding(CdrReader.class, CdrWriter.class, CdrReader::new, CdrWriter::new);

  /** Makes what reads a message. */
  @FunctionalInterface
  public interface Opener {

    /**
     * Starts to read.
     *
     * @param message the whole message and nothing else, from position to limit
     * @return what reads it, at the first field
     * @throws MessageException if the bytes are no message of the encoding
     */
    FieldReader open(ByteBuffer message) throws MessageException;
  }

  /** Checks that nothing is missing. */
  public Encoding {
    Objects.requireNonNull(readerType, "readerType");
    Objects.requireNonNull(writerType, "writerType");
    Objects.requireNonNull(opener, "opener");
    Objects.requireNonNull(maker, "maker");
  }

  /**
   * Starts to read a message.
   *
   * @param message the whole message and nothing else, from position to limit; slices of it may be handed out
   * @return what reads it, at the first field
   * @throws MessageException if the bytes are no message of this encoding
   */
  public FieldReader reader(ByteBuffer message) throws MessageException {
    return opener.open(message);
  }

  /**
   * Starts to write a message.
   *
   * @return what writes it, at the first field
   */
  public FieldWriter writer() {
    return maker.get();
  }
}
