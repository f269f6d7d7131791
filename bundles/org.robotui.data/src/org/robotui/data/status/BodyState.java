package org.robotui.data.status;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;

/**
 * The state of a whole robot as one tree: its parts, and what each of them said last.
 *
 * @param parts sorted by name
 */
public record BodyState(List<Part> parts) implements Data {
  /**
   * A part that speaks for itself.
   *
   * @param name one of its kind in the body
   * @param level how it does
   * @param state the word of the robot's software for that
   * @param reason why it is so; empty where all is well
   * @param silence seconds since it was heard
   * @param restarts how often it was started again after it failed
   * @param received messages that came of it
   * @param lost messages that did not
   * @param says what it said last, sorted by name
   */
  public record Part(String name, Diagnostics.Level level, String state, String reason, double silence, long restarts,
      long received, long lost, List<Saying> says) {
    /**
     * Copies the list.
     *
     * @param name the name
     * @param level how it does
     * @param state the word for it
     * @param reason why
     * @param silence seconds
     * @param restarts how often
     * @param received messages
     * @param lost messages
     * @param says what it said
     */
    public Part {
      says = List.copyOf(says);
    }
  }

  /**
   * What a part said last by one name.
   *
   * @param name of the message
   * @param age seconds since it came
   * @param content what it says
   */
  public record Saying(String name, double age, DynamicRecord content) {}

  /**
   * Copies the list.
   *
   * @param parts sorted by name
   */
  public BodyState {
    parts = List.copyOf(parts);
  }
}
