package org.robotui.uic.jointcontrol.internal.model;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/**
 * A joint, at one moment.
 *
 * @param chain the chain that it is listed in, empty where it is in none
 * @param model its limits
 * @param state what is measured and commanded
 * @param aim where the user drives it, while that is so
 * @param measure how its figures are written
 */
public record JointRow(String chain, JointModel.Joint model, JointControl.Joint state, Optional<Aim> aim,
    Measure measure) implements JointLine {
  @Override
  public String key() {
    return chain + "/" + model.name();
  }

  /** Its name. */
  public String name() {
    return model.name();
  }

  /** From where to where its bar goes. */
  public Span span() {
    return Span.of(model);
  }

  /** Whether its reference is a position: what stands in the field counts only then. */
  public boolean hasReference() {
    return state.modes().contains(JointMode.POSITION) && Double.isFinite(state.reference().position());
  }

  /** How it is doing: a fault of the hardware before all. */
  public Health health() {
    return state.faults() != 0 ? Health.BAD : health(state.source());
  }

  /** How good it is to have this source. */
  public static Health health(JointControl.Source source) {
    return switch (source) {
      case COMMANDED -> Health.OK;
      case HOLDING -> Health.WARNING;
      case SAFE -> Health.BAD;
      case FREE -> Health.NONE;
    };
  }

  /** Where its reference comes from, in a word. */
  public String source() {
    return switch (state.source()) {
      case COMMANDED -> "commanded";
      case HOLDING -> "holding";
      case SAFE -> "safe state";
      case FREE -> "free";
    };
  }

  /** The same in a sentence. */
  public String sourceSentence() {
    String owner = state.owner().isEmpty() ? "its owner" : state.owner();
    return switch (state.source()) {
      case COMMANDED -> owner + " commands it";
      case HOLDING -> owner + " missed its time: it holds";
      case SAFE -> owner + " missed too often, or died: it is in its safe state until it is given anew";
      case FREE -> "Nobody owns it: it holds";
    };
  }

  /** The plugin that owns it, or a dash. */
  public String owner() {
    return state.owner().isEmpty() ? Figures.UNKNOWN : state.owner();
  }

  /** What of its reference is meant, in short words. */
  public String modes() {
    String words = state.modes().stream().sorted().map(JointRow::word).collect(Collectors.joining(" "));
    return words.isEmpty() ? Figures.UNKNOWN : words;
  }

  private static String word(JointMode mode) {
    return switch (mode) {
      case POSITION -> "pos";
      case VELOCITY -> "vel";
      case EFFORT -> "eff";
      case STIFFNESS -> "K";
      case DAMPING -> "D";
    };
  }

  /** Stiffness and damping, where they are meant. */
  public String gains() {
    List<String> parts = new ArrayList<>();
    parts.add(state.modes().contains(JointMode.STIFFNESS) ? Figures.fixed(state.reference().stiffness(), 0)
        : Figures.UNKNOWN);
    parts.add(
        state.modes().contains(JointMode.DAMPING) ? Figures.fixed(state.reference().damping(), 1) : Figures.UNKNOWN);
    return String.join(" / ", parts);
  }

  /** The hotter of motor and driver, degrees Celsius; NaN where neither is known. */
  public double temperature() {
    double motor = state.measured().motorTemperature();
    double driver = state.measured().driverTemperature();
    return Double.isNaN(motor) ? driver : Double.isNaN(driver) ? motor : Math.max(motor, driver);
  }

  /** How much of its effort it uses, 0 to 1; NaN where that is not known. */
  public double effortShare() {
    boolean known = Double.isFinite(model.effort()) && model.effort() > 0;
    return known ? Math.min(1, Math.abs(state.measured().effort()) / model.effort()) : Double.NaN;
  }

  /** The bits of its fault, or a dash. */
  public String faults() {
    return state.faults() == 0 ? Figures.UNKNOWN : "0x" + String.format(Locale.ROOT, "%02x", state.faults());
  }

  /** The same in a sentence. */
  public String faultSentence() {
    if (state.faults() == 0) {
      return "No fault";
    }
    List<Integer> bits = BitSet.valueOf(new long[]{state.faults()}).stream().boxed().toList();
    String numbers = bits.stream().map(String::valueOf).collect(Collectors.joining(", "));
    return "The hardware reports fault " + faults() + (bits.size() == 1 ? ", bit " : ", bits ") + numbers;
  }

  /** How many of its commands were cut, and how many refused. */
  public String counts() {
    return state.clamped() + " / " + state.rejected();
  }
}
