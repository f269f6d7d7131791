package org.robotui.data.command;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.Late;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/**
 * A value of one robot that is said to the software of another one, on a topic that stays offered as long as values
 * come. The robot interface makes a message of it: of the message that it came as, where its topic carries the same
 * type, else of the value.
 *
 * @param topic the robot's name of the topic
 * @param type the robot's name of the type; empty where the robot interface is to find the one that fits
 * @param value what is said
 * @param stamp when it was measured, by the clock of the robot to which it is said; none where nobody knows
 * @param original the message that it came as
 * @param kept whether those who subscribe later get the last one
 * @param guarded whether it commands: then it needs the lease, and is refused while the robot is stopped
 * @param answer hears what became of it
 */
@Delivery(conflation = Conflation.EVENT, late = Late.NONE, expires = false)
public record RelayMessage(String topic, String type, Data value, Optional<Stamp> stamp, Original original,
    boolean kept, boolean guarded, Answer answer) implements Data {

  /** Hears what became of a message. */
  @FunctionalInterface
  public interface Answer {
    /** Of who does not want to know. */
    Answer NOBODY = refusal -> {};

    /**
     * It was said, or not. Called on the thread that says it; must not block.
     *
     * @param refusal why it was not said, a sentence for users; none where it was
     */
    void told(Optional<String> refusal);
  }

  /**
   * The message that a value came as.
   *
   * @param type the name of its type, of the robot that sent it; empty where there is no such message
   * @param record reads it, on any thread; nothing where it cannot be read
   * @param wire its bytes, where nothing is to be changed in it
   */
  public record Original(String type, Supplier<Optional<DynamicRecord>> record, Optional<Wire> wire) {
    /** Of values that came as no message, or were changed since. */
    public static final Original NONE = new Original("", Optional::empty);

    /**
     * A message whose bytes are not to be said as they are.
     *
     * @param type the name of its type
     * @param record reads it
     */
    public Original(String type, Supplier<Optional<DynamicRecord>> record) {
      this(type, record, Optional.empty());
    }
  }

  /**
   * A message as it came, for a robot interface that has the same type in the same encoding.
   *
   * @param encoding the name of the encoding
   * @param definition the text of the type, on any thread; nothing where it is not known
   * @param bytes the whole message
   */
  public record Wire(String encoding, Supplier<Optional<String>> definition, Bytes bytes) {}
}
