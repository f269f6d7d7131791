package org.robotui.uic.jointcontrol.internal.model;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.joint.JointControl.Measured;
import org.robotui.data.joint.JointControl.Reference;
import org.robotui.data.joint.JointMode;
import org.robotui.ui.Figures;

/** All that is known of one joint, in a few lines. Pure. */
public final class JointDetail {
  private static final String BETWEEN = "  \u00b7  ";

  private JointDetail() {}

  /**
   * A line.
   *
   * @param label what it is about
   * @param text what there is to say
   * @param bad whether something is broken
   */
  public record Entry(String label, String text, boolean bad) {}

  /** The lines, always as many. */
  public static List<Entry> of(JointRow row) {
    return List.of(
        new Entry("Commanded", commanded(row) + BETWEEN + row.sourceSentence(), false),
        new Entry("Motor", motor(row), false),
        row.state().faults() != 0 ? new Entry("Fault", row.faultSentence(), true)
            : new Entry("Limits", limits(row), false));
  }

  private static String commanded(JointRow row) {
    Reference reference = row.state().reference();
    Measure measure = row.measure();
    String words = Stream.of(
        has(row, JointMode.POSITION, measure.position(reference.position())),
        has(row, JointMode.VELOCITY, measure.velocity(reference.velocity())),
        has(row, JointMode.EFFORT, measure.effort(reference.effort())))
        .filter(part -> !part.isEmpty()).collect(Collectors.joining(BETWEEN));
    return words.isEmpty() ? Figures.UNKNOWN : words;
  }

  private static String has(JointRow row, JointMode mode, String words) {
    return row.state().modes().contains(mode) ? words : "";
  }

  private static String motor(JointRow row) {
    Measured measured = row.state().measured();
    return String.join(BETWEEN, row.measure().position(measured.motorPosition()),
        row.measure().velocity(measured.motorVelocity()),
        celsius(measured.motorTemperature()), "driver " + celsius(measured.driverTemperature()));
  }

  private static String limits(JointRow row) {
    String span = row.span().limited()
        ? row.measure().position(row.span().lower()) + " to " + row.measure().position(row.span().upper())
        : "no end";
    return String.join(BETWEEN, span, row.measure().velocity(row.model().velocity()),
        row.measure().effort(row.model().effort()),
        row.state().clamped() + " cut, " + row.state().rejected() + " refused");
  }

  private static String celsius(double value) {
    return Double.isNaN(value) ? Figures.UNKNOWN : Figures.of(value, 1, "\u00b0C");
  }
}
