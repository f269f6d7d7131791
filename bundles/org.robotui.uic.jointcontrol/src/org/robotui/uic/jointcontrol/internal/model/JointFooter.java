package org.robotui.uic.jointcontrol.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Health;

/**
 * The line below the table: who drives, and what can be done about it. Always there, so that nothing jumps.
 *
 * @param health the dot
 * @param text what is said
 * @param buttons at most two, the leftmost first
 */
public record JointFooter(Health health, String text, List<Button> buttons) {
  private static final int PERCENT = 100;

  /** What can be pressed there. */
  public enum Button {
    /** The answer to the question. */
    DRIVE("Drive joints"),
    /** The answer where somebody else has control. */
    TAKE_OVER("Take over and drive"),
    /** The other answer. */
    CANCEL("Cancel"),
    /** Gives control of the robot back. */
    RELEASE_CONTROL("Release control"),
    /** Unlatches the stop. */
    RELEASE_STOP("Release");

    private final String label;

    Button(String label) {
      this.label = label;
    }

    /** As users read it; what is released is said, since the title bar of the window releases others as well. */
    public String label(String robot) {
      return this == RELEASE_STOP ? label + " " + robot : label;
    }

    /** Whether it is the one thing to press. */
    public boolean urgent() {
      return this == RELEASE_STOP || this == TAKE_OVER || this == DRIVE;
    }
  }

  /** What there is to say. */
  public static JointFooter of(DriveLook look) {
    if (look.stoppedBy().isPresent()) {
      String ended = look.told().isPresent() ? ": joints are not driven any more" : "";
      return new JointFooter(Health.BAD, "Stopped by " + look.stoppedBy().get() + ended, List.of(Button.RELEASE_STOP));
    }
    return switch (look.phase()) {
      case ASKING -> question(look);
      case DRIVING -> driving(look);
      case MONITOR -> monitor(look);
    };
  }

  private static JointFooter question(DriveLook look) {
    String drive = "rive " + look.moves() + " of " + look.robot() + "? They move when you set a target, at "
        + Math.round(look.speed() * PERCENT) + "\u00a0% of their speed at most"
        + look.owners().map(o -> ". " + o).orElse("");
    return look.holder()
        .map(other -> new JointFooter(Health.WARNING, other + " has control now. Take over and d" + drive,
            List.of(Button.TAKE_OVER, Button.CANCEL)))
        .orElseGet(() -> new JointFooter(Health.WARNING, "D" + drive, List.of(Button.DRIVE, Button.CANCEL)));
  }

  private static JointFooter driving(DriveLook look) {
    String how = look.jog() ? "hold a bar, or \u2190 \u2192, to move" : "drag a knob, type, or \u2190 \u2192";
    return look.told().map(told -> new JointFooter(Health.WARNING, told, List.of()))
        .orElseGet(
            () -> new JointFooter(Health.OK, "You control " + look.robot() + ": " + how + "; Esc ends", List.of()));
  }

  private static JointFooter monitor(DriveLook look) {
    List<Button> back = look.mine() ? List.of(Button.RELEASE_CONTROL) : List.of();
    Optional<String> warning = look.told().or(() -> look.blocked().map(why -> "Cannot drive: " + why));
    return warning.map(words -> new JointFooter(look.told().isPresent() ? Health.WARNING : Health.NONE, words, back))
        .orElseGet(() -> new JointFooter(Health.NONE, "Monitoring: this view commands nothing", back));
  }
}
