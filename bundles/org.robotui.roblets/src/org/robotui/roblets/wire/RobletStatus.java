package org.robotui.roblets.wire;

import org.robotui.roblets.tree.BodyElement;

/**
 * How a roblet is, as its brain sees it.
 *
 * @param form what it says and takes
 * @param state {@code starting}, {@code running}, {@code hanging}, {@code failed}, {@code stopped} by its own beacons;
 * {@code silent} where none comes any more
 * @param reason why it is so; empty where all is well
 * @param address from where its beacons come
 * @param restarts how often it was started again after it failed
 * @param silentSeconds since its last beacon
 * @param tally what came of it
 */
public record RobletStatus(RobletForm form, String state, String reason, String address, long restarts,
    double silentSeconds, ArrivalOrder.Tally tally) {
  /** A roblet that does what it should. */
  public static final String RUNNING = "running";

  /** A roblet of which no beacon comes any more. */
  public static final String SILENT = "silent";

  /** A roblet that has gone with a word. */
  public static final String STOPPED = "stopped";

  private static final int LONGEST = 200;

  /**
   * Bounds the texts.
   *
   * @param form its form
   * @param state its state
   * @param reason why
   * @param address from where
   * @param restarts how often
   * @param silentSeconds since its last beacon
   * @param tally what came of it
   */
  public RobletStatus {
    state = bounded(state);
    reason = bounded(reason);
    address = bounded(address);
  }

  private static String bounded(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "...";
  }

  /**
   * Written into a datagram.
   *
   * @return the form with the state
   */
  public BodyElement element() {
    return form.element().with("state", state).with("reason", reason).with("address", address)
        .with("restarts", restarts).with("silent", silentSeconds).with("received", tally.received())
        .with("lost", tally.lost()).with("late", tally.late()).with("doubled", tally.doubled())
        .with("runs", tally.runs());
  }

  /**
   * Read from a datagram.
   *
   * @param element as it was written
   * @return how the roblet is
   * @throws IllegalArgumentException where a name is none
   */
  public static RobletStatus of(BodyElement element) {
    return new RobletStatus(RobletForm.of(element), element.attribute("state").orElse("running"),
        element.attribute("reason").orElse(""), element.attribute("address").orElse(""), whole(element, "restarts"),
        element.number("silent").orElse(0),
        new ArrivalOrder.Tally(whole(element, "received"), whole(element, "lost"), whole(element, "late"),
            whole(element, "doubled"), (int) whole(element, "runs")));
  }

  private static long whole(BodyElement element, String attribute) {
    return (long) element.number(attribute).orElse(0);
  }
}
