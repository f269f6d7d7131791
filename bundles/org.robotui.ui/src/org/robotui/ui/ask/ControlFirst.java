package org.robotui.ui.ask;

import java.util.Optional;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.Principal;
import org.robotui.api.host.RuicView;

/**
 * Takes control of the robot before something is changed: where nobody has it at once, else when the user confirmed.
 * What was to be done waits for the answer. All threads; never blocks.
 */
public final class ControlFirst {
  private final RuicView ruic;
  private final Principal principal;
  private Optional<Waiting> waiting = Optional.empty();

  /**
   * The user is asked whether to take over.
   *
   * @param holder who has control
   * @param robot of which robot
   */
  public record Question(String holder, String robot) {}

  private record Waiting(Authority authority, Runnable action, Runnable given, Question question) {}

  /**
   * Asks for nothing yet.
   *
   * @param context whose robots, and who takes control
   */
  public ControlFirst(UicContext context) {
    ruic = context.ruic();
    principal = context.principal();
  }

  /**
   * Does something as soon as control is taken, or something else where the user does not want that or wants something
   * new.
   *
   * @param robot whose control is taken; one without an authority needs none
   * @param action is run once, at once or when the user has confirmed
   * @param givenUp is run once in its place
   */
  public void with(String robot, Runnable action, Runnable givenUp) {
    leave();
    Optional<Authority> authority = ruic.authority(robot);
    if (authority.isEmpty() || granted(authority.get(), action, givenUp)) {
      action.run();
    }
  }

  private synchronized boolean granted(Authority authority, Runnable action, Runnable givenUp) {
    if (authority.take(principal, false) instanceof LeaseOutcome.HeldBy held) {
      waiting =
          Optional.of(new Waiting(authority, action, givenUp, new Question(held.holder().label(), authority.robot())));
      return false;
    }
    waiting = Optional.empty();
    return true;
  }

  /**
   * Whether the user has control, so that nothing has to be asked.
   *
   * @param robot whose control
   * @return true also where the robot has no authority
   */
  public boolean isMine(String robot) {
    return ruic.authority(robot).map(a -> a.holder().filter(principal::equals).isPresent()).orElse(true);
  }

  /**
   * What the user is asked.
   *
   * @return none where nothing waits for an answer
   */
  public synchronized Optional<Question> question() {
    return waiting.map(Waiting::question);
  }

  /** The user confirmed: takes over and does what was to be done. */
  public void takeOver() {
    Optional<Waiting> now = answered();
    now.ifPresent(w -> {
      w.authority().take(principal, true);
      w.action().run();
    });
  }

  /** The user does not want to take over. */
  public void leave() {
    answered().ifPresent(w -> w.given().run());
  }

  private synchronized Optional<Waiting> answered() {
    Optional<Waiting> now = waiting;
    waiting = Optional.empty();
    return now;
  }
}
