package org.robotui.api.port;

import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/**
 * A message as it came, for bridges and recorders, so that nothing unknown is lost.
 *
 * @param schema the robot's name of the type
 * @param encoding how the bytes are to be read, for example {@code ros1}
 * @param bytes the bytes
 * @param reader reads the bytes
 * @param origin where it came from, and how its type is defined
 */
public record RawMessage(String schema, String encoding, Bytes bytes, Reader reader, RawOrigin origin) {
  /** Reads messages of one type; safe for all threads. */
  @FunctionalInterface
  public interface Reader {
    /** Of messages that nobody can read. */
    Reader NONE = bytes -> Optional.empty();

    /**
     * Reads a message.
     *
     * @param bytes the bytes
     * @return its fields with the robot's names, or none where they cannot be read
     */
    Optional<DynamicRecord> read(Bytes bytes);
  }

  /**
   * A message of which nothing else is known.
   *
   * @param schema the robot's name of the type
   * @param encoding how the bytes are to be read
   * @param bytes the bytes
   * @param reader reads the bytes
   */
  public RawMessage(String schema, String encoding, Bytes bytes, Reader reader) {
    this(schema, encoding, bytes, reader, RawOrigin.UNKNOWN);
  }

  /**
   * The message with the robot's names.
   *
   * @return its fields, or none where they cannot be read
   */
  public Optional<DynamicRecord> record() {
    return reader.read(bytes);
  }
}
