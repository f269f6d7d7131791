package org.robotui.uic.teleop.internal;

import java.util.List;
import java.util.function.Predicate;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;

/**
 * The line below the stick: who drives, and what can be done about it. Always there, so that nothing jumps.
 *
 * @param health the dot
 * @param texts what is to be said, the longest first; each shorter one leaves out what matters least
 * @param buttons at most two, the rightmost first
 */
record TeleopFooter(Health health, List<String> texts, List<Button> buttons) {
  /** What can be pressed there. */
  enum Button {
    TAKE("Take control"),
    RELEASE_CONTROL("Release control"),
    ASK("Take over\u2026"),
    TAKE_OVER("Take over"),
    CANCEL("Cancel"),
    RELEASE_STOP("Release");

    private final String label;

    Button(String label) {
      this.label = label;
    }

    /** For a robot: what is released is said, since the title bar of the window releases others as well. */
    String label(String robot) {
      return this == RELEASE_STOP ? label + " " + robot : label;
    }

    /** Whether it is the one thing to press. */
    boolean urgent() {
      return this == RELEASE_STOP || this == TAKE_OVER;
    }
  }

  static TeleopFooter of(TeleopViewState look) {
    return look.stoppedBy().map(TeleopFooter::stopped).orElseGet(() -> switch (look.lease()) {
      case TeleopViewState.Lease.Free f -> look.navigates() ? navigating(look, Button.TAKE)
          : free(StateView.showsContent(look.output()));
      case TeleopViewState.Lease.Mine m -> mine(look);
      case TeleopViewState.Lease.Other o -> other(o.name(), look.asking());
    });
  }

  /** The whole sentence. */
  String text() {
    return texts.getFirst();
  }

  /** The longest text that fits, else the shortest, which then must be cut. */
  String fitting(Predicate<String> fits) {
    return texts.stream().filter(fits).findFirst().orElse(texts.getLast());
  }

  private static TeleopFooter stopped(String by) {
    return new TeleopFooter(Health.BAD, List.of("Stopped by " + by, "Stopped"), List.of(Button.RELEASE_STOP));
  }

  private static TeleopFooter free(boolean connected) {
    return connected
        ? new TeleopFooter(Health.NONE,
            List.of("Nobody has control. Drag the stick or hold a key.", "Nobody has control", "Free"),
            List.of(Button.TAKE))
        : new TeleopFooter(Health.NONE, List.of("Nothing to drive"), List.of());
  }

  private static TeleopFooter mine(TeleopViewState look) {
    // What is held but not reached is not driven: the lease alone makes nothing good.
    if (!StateView.showsContent(look.output())) {
      // The reason stands in place of the stick.
      return new TeleopFooter(Health.WARNING, List.of("Cannot drive: " + look.output().explanation(), "Cannot drive"),
          List.of(Button.RELEASE_CONTROL));
    }
    if (!(look.output() instanceof InputState.Live)) {
      return held("Cannot drive", look.output().explanation());
    }
    if (look.navigates() && !look.held() && look.refusal().isEmpty()) {
      return navigating(look, Button.RELEASE_CONTROL);
    }
    return look.refusal().map(why -> held("Not sent", why))
        .orElseGet(() -> new TeleopFooter(Health.OK, List.of("You control " + look.robot(), "You have control"),
            List.of(Button.RELEASE_CONTROL)));
  }

  private static TeleopFooter navigating(TeleopViewState look, Button button) {
    return new TeleopFooter(Health.OK,
        List.of("Navigation drives " + look.robot() + " to a goal, within limits of its own",
            "Navigation drives, within its own limits", "Navigation drives " + look.robot(), "Navigation drives"),
        List.of(button));
  }

  private static TeleopFooter held(String what, String why) {
    return new TeleopFooter(Health.WARNING, List.of(what + ": " + why), List.of(Button.RELEASE_CONTROL));
  }

  private static TeleopFooter other(String name, boolean asking) {
    return asking
        ? new TeleopFooter(Health.WARNING, List.of(name + " has control. Take over?", name + " has control"),
            List.of(Button.TAKE_OVER, Button.CANCEL))
        : new TeleopFooter(Health.WARNING, List.of(name + " has control"), List.of(Button.ASK));
  }
}
