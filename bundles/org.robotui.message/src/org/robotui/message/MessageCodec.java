package org.robotui.message;

import java.nio.ByteBuffer;

/**
 * Turns the bytes of one message type into a Java value and back. A codec is stateless and may be used by several
 * threads at once.
 *
 * @param <T> the Java value of a message
 */
public interface MessageCodec<T> {

  /**
   * The message type this codec speaks.
   *
   * @return the identity announced to peers
   */
  MessageInfo info();

  /**
   * Decodes one message.
   *
   * @param in the whole message and nothing else, little endian, from its position to its limit. The codec may keep
   * slices of it: the transport hands over a fresh array and never writes to it again
   * @return the value
   * @throws MessageException if the bytes are no message of this type
   */
  T decode(ByteBuffer in) throws MessageException;

  /**
   * Decodes one message of a peer whose own identity is known. Codecs for one fixed type need not care; a codec that
   * accepts any type finds the type and its definition here.
   *
   * @param in as for {@link #decode(ByteBuffer)}
   * @param peer the identity the peer announced in its connection header
   * @return the value
   * @throws MessageException if the bytes are no message of this type
   */
  default T decode(ByteBuffer in, MessageInfo peer) throws MessageException {
    return decode(in);
  }

  /**
   * Appends one message to a writer.
   *
   * @param value the value to encode
   * @param out where the bytes go, without a length prefix
   */
  void encode(T value, MessageWriter out);
}
