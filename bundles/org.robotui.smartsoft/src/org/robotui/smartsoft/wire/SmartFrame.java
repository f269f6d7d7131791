package org.robotui.smartsoft.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;

/**
 * One message on its way. Both parts are CDR without encapsulation, each aligned to its own beginning.
 *
 * @param command what it is for: a number of {@link SmartCommand}, or of {@link NamingCommand}
 * @param order of the bytes of all numbers in it
 * @param pattern what the communication pattern says: identifiers, subscriptions, texts of a naming service
 * @param object the communication object of users; empty where there is none
 */
public record SmartFrame(int command, ByteOrder order, ByteBuffer pattern, ByteBuffer object) {

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  /** Takes both parts as they are, from their positions to their limits. */
  public SmartFrame {
    pattern = pattern.slice().asReadOnlyBuffer().order(order);
    object = object.slice().asReadOnlyBuffer().order(order);
  }

  /**
   * A message without data.
   *
   * @param command what it is for
   * @return little endian
   */
  public static SmartFrame of(SmartCommand command) {
    return new SmartFrame(command.number(), ByteOrder.LITTLE_ENDIAN, NOTHING, NOTHING);
  }

  /**
   * A message of a pattern.
   *
   * @param command what it is for
   * @param pattern what the pattern says, without encapsulation
   * @return little endian
   */
  public static SmartFrame of(SmartCommand command, CdrWriter pattern) {
    return of(command, pattern, NOTHING);
  }

  /**
   * A message with a communication object.
   *
   * @param command what it is for
   * @param pattern what the pattern says, without encapsulation
   * @param object the object, little endian
   * @return little endian
   */
  public static SmartFrame of(SmartCommand command, CdrWriter pattern, ByteBuffer object) {
    return new SmartFrame(command.number(), ByteOrder.LITTLE_ENDIAN, pattern.view(), object);
  }

  /**
   * Writes what a pattern says.
   *
   * @return empty, little endian
   */
  public static CdrWriter data() {
    return CdrWriter.plain(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Reads what the pattern says.
   *
   * @return at its beginning
   */
  public CdrReader reader() {
    return new CdrReader(pattern, order);
  }

  /**
   * What the pattern says.
   *
   * @return a view of its own, in the order of its bytes
   */
  @Override
  public ByteBuffer pattern() {
    return pattern.duplicate().order(order);
  }

  /**
   * The communication object.
   *
   * @return a view of its own, in the order of its bytes
   */
  @Override
  public ByteBuffer object() {
    return object.duplicate().order(order);
  }
}
