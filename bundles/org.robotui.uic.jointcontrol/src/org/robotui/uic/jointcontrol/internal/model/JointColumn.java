package org.robotui.uic.jointcontrol.internal.model;

import java.util.Comparator;
import java.util.Optional;
import org.robotui.ui.Figures;
import org.robotui.ui.control.NaturalOrder;

/** The columns of the table: how wide they are, and how much they matter where room is scarce. */
public enum JointColumn {
  /** Its name, with a dot for how it is doing. */
  NAME("Joint", 128, 2, 0, Comparator.comparing(JointRow::name, NaturalOrder.ORDER)),
  /** Where its reference comes from. */
  SOURCE("Source", 104, 0, 3, Comparator.comparing(r -> r.state().source())),
  /** The bar between the limits. */
  RANGE("Measured and commanded", 116, 6, 0,
      Comparator.comparingDouble(r -> r.span().share(r.state().measured().position()))),
  /** The measured position. */
  POSITION("Position", 96, 0, 1, Comparator.comparingDouble(r -> r.state().measured().position())),
  /** Where the user drives it. */
  TARGET("Target", 96, 0, 2, Comparator.comparingDouble(r -> r.aim().map(Aim::goal).orElse(Double.NaN))),
  /** The measured velocity. */
  VELOCITY("Velocity", 104, 0, 5, Comparator.comparingDouble(r -> r.state().measured().velocity())),
  /** The measured effort against its limit. */
  EFFORT("Effort", 100, 0, 4, Comparator.comparingDouble(r -> r.state().measured().effort())),
  /** The hotter of motor and driver. */
  TEMPERATURE("Temp.", 64, 0, 8, Comparator.comparingDouble(JointRow::temperature)),
  /** What of the reference is meant. */
  MODE("Mode", 72, 0, 10, Comparator.comparing(JointRow::modes)),
  /** Stiffness and damping. */
  GAINS("K / D", 96, 0, 11, Comparator.comparingDouble(r -> r.state().reference().stiffness())),
  /** The plugin that commands it. */
  OWNER("Owner", 124, 0, 6, Comparator.comparing(JointRow::owner)),
  /** Bits of the hardware. */
  FAULTS("Faults", 64, 0, 7, Comparator.comparingLong(r -> r.state().faults())),
  /** Commands that were cut or refused. */
  COUNTS("Cut / ref.", 84, 0, 9, Comparator.comparingLong(r -> r.state().clamped() + r.state().rejected()));

  /** What is sacrificed no sooner than this tells where a joint is, which matters more than its whole name. */
  static final int POSITIONS = 2;

  private static final int WIDEST_RANGE = 280;

  private final String title;
  private final int width;
  private final int weight;
  private final int sacrifice;
  private final Comparator<JointRow> order;

  JointColumn(String title, int width, int weight, int sacrifice, Comparator<JointRow> order) {
    this.title = title;
    this.width = width;
    this.weight = weight;
    this.sacrifice = sacrifice;
    this.order = order;
  }

  /** The heading. */
  public String title() {
    return title;
  }

  /** The heading where room is scarce. */
  public String shortTitle() {
    return this == RANGE ? "Range" : title;
  }

  /** How wide it is at least. The bar, on which hands need room, gets a quarter of the table. */
  int width(int room) {
    return this == RANGE ? Math.clamp(room / 4, width, WIDEST_RANGE) : width;
  }

  int weight() {
    return weight;
  }

  /** The greater, the sooner it goes where room is scarce; 0 stays. */
  int sacrifice() {
    return sacrifice;
  }

  /** How joints are sorted by it. */
  public Comparator<JointRow> order() {
    return order;
  }

  /** Whether its figures stand at the right. */
  public boolean isFigure() {
    return switch (this) {
      case NAME, SOURCE, RANGE, MODE, OWNER, FAULTS -> false;
      default -> true;
    };
  }

  /** What stands in a cell; empty where it is painted. */
  public String text(JointRow row) {
    return switch (this) {
      case NAME -> row.name();
      case SOURCE -> row.source();
      case RANGE -> "";
      case POSITION -> row.measure().position(row.state().measured().position());
      case TARGET -> row.aim().map(aim -> row.measure().position(aim.goal())).orElse("");
      case VELOCITY -> row.measure().velocity(row.state().measured().velocity());
      case EFFORT -> row.measure().effort(row.state().measured().effort());
      case TEMPERATURE -> Double.isNaN(row.temperature()) ? Figures.UNKNOWN
          : Figures.of(row.temperature(), 0, "\u00b0C");
      case MODE -> row.modes();
      case GAINS -> row.gains();
      case OWNER -> row.owner();
      case FAULTS -> row.faults();
      case COUNTS -> row.counts();
    };
  }

  /** What a tooltip says of a cell; empty where it says no more than the cell. */
  public Optional<String> hint(JointRow row) {
    return switch (this) {
      case NAME -> Optional.of(row.name() + ", " + row.sourceSentence() + ". " + row.faultSentence());
      case SOURCE, OWNER -> Optional.of(row.sourceSentence());
      case RANGE -> Optional.of(RangeWords.of(row));
      case EFFORT -> Optional.of("Of " + row.measure().effort(row.model().effort()));
      case VELOCITY -> Optional.of("Of " + row.measure().velocity(row.model().velocity()));
      case TEMPERATURE -> Optional.of("Motor " + temperature(row.state().measured().motorTemperature()) + ", driver "
          + temperature(row.state().measured().driverTemperature()));
      case FAULTS -> Optional.of(row.faultSentence());
      case COUNTS -> Optional
          .of(row.state().clamped() + " commands were cut at a limit, " + row.state().rejected() + " refused");
      case GAINS -> Optional
          .of("Stiffness " + row.measure().stiffness(row.state().reference().stiffness()) + ", damping "
              + row.measure().damping(row.state().reference().damping()));
      case POSITION, TARGET, MODE -> Optional.empty();
    };
  }

  private static String temperature(double celsius) {
    return Double.isNaN(celsius) ? "not known" : Figures.of(celsius, 1, "\u00b0C");
  }
}
