package org.robotui.uic.teleop.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;

/**
 * The line below the stick: who drives, and what can be done about it. Always there, so that nothing jumps.
 *
 * @param health the dot
 * @param text a sentence
 * @param buttons at most two, the rightmost first
 */
record Footer(Health health, String text, List<Button> buttons) {
  /** What can be pressed there. */
  enum Button {
    TAKE("Take control"),
    GIVE_BACK("Give back"),
    ASK("Take over\u2026"),
    TAKE_OVER("Take over"),
    CANCEL("Cancel"),
    RELEASE_STOP("Release stop");

    private final String label;

    Button(String label) {
      this.label = label;
    }

    String label() {
      return label;
    }

    /** Whether it is the one thing to press. */
    boolean urgent() {
      return this == RELEASE_STOP || this == TAKE_OVER;
    }
  }

  static Footer of(Look look) {
    return look.stoppedBy().map(Footer::stopped).orElseGet(() -> switch (look.lease()) {
      case Look.Lease.Free f -> free(StateView.showsContent(look.output()));
      case Look.Lease.Mine m -> mine(look.robot(), look.refusal());
      case Look.Lease.Other o -> other(o.name(), look.asking());
    });
  }

  private static Footer stopped(String by) {
    return new Footer(Health.BAD, "Stopped by " + by, List.of(Button.RELEASE_STOP));
  }

  private static Footer free(boolean connected) {
    return connected
        ? new Footer(Health.NONE, "Nobody drives. Drag the stick or hold a key.", List.of(Button.TAKE))
        : new Footer(Health.NONE, "Nothing to drive", List.of());
  }

  private static Footer mine(String robot, Optional<String> refusal) {
    return refusal
        .map(why -> new Footer(Health.WARNING, "Not sent: " + why, List.of(Button.GIVE_BACK)))
        .orElseGet(() -> new Footer(Health.OK, "You drive " + robot, List.of(Button.GIVE_BACK)));
  }

  private static Footer other(String name, boolean asking) {
    return asking
        ? new Footer(Health.WARNING, name + " drives. Take over?", List.of(Button.TAKE_OVER, Button.CANCEL))
        : new Footer(Health.WARNING, name + " drives", List.of(Button.ASK));
  }
}
