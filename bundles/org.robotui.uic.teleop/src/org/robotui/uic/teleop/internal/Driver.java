package org.robotui.uic.teleop.internal;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Twist;
import org.robotui.data.navigation.NavigationStatus;

/**
 * Turns what the hands want into commands, within lease and stop. Hands come from the display thread, ticks from the
 * view's worker: one lock, never held while anything blocks, so that no command follows the release that ends it.
 */
final class Driver {
  /** Navigation tells its progress several times as often. */
  private static final double MOMENT_SECONDS = 1.5;
  private static final Duration VALID = Duration.ofMillis(250);
  /** For how long a gamepad drives although its view was not seen. */
  private static final long SEEN_NANOS = 400_000_000;

  private final TeleopModel model = new TeleopModel();
  private final Output<VelocityCommand> output;
  private final Input<Twist> odometry;
  private final Input<NavigationStatus> navigation;
  private final Principal principal;
  private final SettingsStore settings;
  private boolean moving;
  private boolean asking;
  private Optional<Long> seen = Optional.empty();
  private String padState = "";
  private Optional<String> refusal = Optional.empty();

  Driver(Output<VelocityCommand> output, Input<Twist> odometry, Input<NavigationStatus> navigation, Principal principal,
      SettingsStore settings) {
    this.output = output;
    this.odometry = odometry;
    this.navigation = navigation;
    this.principal = principal;
    this.settings = settings;
  }

  synchronized void press(DriveKey key, long now) {
    hands(now, hands -> hands.press(key, now));
  }

  synchronized void release(DriveKey key, long now) {
    hands(now, hands -> hands.release(key, now));
  }

  synchronized void drag(Stick stick, long now) {
    hands(now, hands -> hands.drag(stick));
  }

  synchronized void dragEnd(long now) {
    hands(now, TeleopModel::dragEnd);
  }

  /** The dead-man button of a gamepad is held, and its stick stands there. */
  synchronized void pad(Stick stick, long now) {
    if (isSeen(now)) {
      hands(now, hands -> hands.pad(stick));
    } else {
      model.padLetGo();
    }
  }

  /** Nobody holds the dead-man button any more. */
  synchronized void padEnd(long now) {
    hands(now, TeleopModel::padEnd);
  }

  /** How it stands with the gamepad, in a few words; empty where none is wanted. */
  synchronized void padState(String words) {
    padState = words;
  }

  /** The view can be seen in the window in front: a gamepad drives only what its user sees. */
  synchronized void seen(long now) {
    seen = Optional.of(now);
  }

  private boolean isSeen(long now) {
    return seen.filter(last -> now - last < SEEN_NANOS).isPresent();
  }

  synchronized void half(boolean on) {
    model.half(on);
  }

  /** A grace may have passed: ends the motion where nobody holds on any more. */
  synchronized void settle(long now) {
    if (!model.held(now)) {
      halt();
    }
  }

  /** The user gave up: escape. */
  synchronized void letGo() {
    model.letGo();
    asking = false;
    halt();
  }

  /** Keys are no longer seen: the focus is gone. */
  synchronized void forget() {
    model.forget();
    if (!model.padHeld()) {
      halt();
    }
  }

  /** The view is seen no more: no hand holds on, whatever it lies on. */
  synchronized void leave() {
    seen = Optional.empty();
    model.forget();
    letGo();
  }

  synchronized void stop() {
    authority().stop(principal);
    letGo();
  }

  synchronized void releaseStop() {
    authority().releaseStop(principal);
  }

  /** Takes the lease where it is free, else asks. */
  synchronized void take() {
    asking = !granted(false);
  }

  synchronized void takeOver() {
    asking = !granted(true);
  }

  synchronized void ask(boolean wanted) {
    asking = wanted;
  }

  synchronized void giveBack() {
    letGo();
    authority().giveBack(principal);
  }

  /** Sends what is due. Called from the tick, at the rate at which commands are to be renewed. */
  synchronized void tick(long now) {
    if (!mayDrive()) {
      model.letGo();
    }
    if (model.padHeld() && !isSeen(now)) {
      model.padLetGo();
    }
    if (model.held(now)) {
      send(model.step(now, limits()));
    } else {
      halt();
    }
  }

  synchronized TeleopViewState look(long now) {
    Authority authority = authority();
    return new TeleopViewState(authority.robot(), model.held(now), model.stick(now), model.speed(), measured(),
        limits(),
        lease(authority), authority.stoppedBy().map(Principal::label),
        asking && !(lease(authority) instanceof TeleopViewState.Lease.Mine),
        refusal, navigates(now), output.state(), padState);
  }

  private void hands(long now, Consumer<TeleopModel> change) {
    boolean before = model.held(now);
    change.accept(model);
    if (!model.held(now)) {
      halt();
    } else if (!before) {
      begin();
    }
  }

  private void begin() {
    refusal = Optional.empty();
    asking = authority().stoppedBy().isEmpty() && !granted(false);
    if (!mayDrive()) {
      model.letGo();
    }
  }

  private boolean granted(boolean takeover) {
    return authority().take(principal, takeover) instanceof Authority.LeaseOutcome.Granted;
  }

  private boolean mayDrive() {
    return authority().stoppedBy().isEmpty() && authority().holder().filter(principal::equals).isPresent();
  }

  private void send(Speed speed) {
    moving = true;
    CommandOutcome outcome = output.send(VelocityCommand.planar(speed.forward(), speed.turn()), VALID);
    refusal = outcome instanceof CommandOutcome.Refused refused ? Optional.of(refused.explanation()) : Optional.empty();
  }

  private void halt() {
    if (moving) {
      moving = false;
      refusal = Optional.empty();
      output.release();
    }
  }

  private Optional<Speed> measured() {
    return odometry.state() instanceof InputState.Live
        ? odometry.latest().map(twist -> new Speed(twist.value().linear().x(), twist.value().angular().z()))
        : Optional.empty();
  }

  /** Whether navigation said a moment ago that it drives, and has not said since that it has ended. */
  private boolean navigates(long now) {
    return navigation.sources().stream().flatMap(source -> navigation.latest(source).stream())
        .min(Comparator.comparingDouble(said -> said.ageSeconds(now)))
        .filter(said -> said.value().state() == NavigationStatus.State.ACTIVE && said.ageSeconds(now) < MOMENT_SECONDS)
        .isPresent();
  }

  private TeleopViewState.Lease lease(Authority authority) {
    return authority.holder()
        .map(holder -> holder.equals(principal) ? new TeleopViewState.Lease.Mine()
            : new TeleopViewState.Lease.Other(holder.label()))
        .orElseGet(TeleopViewState.Lease.Free::new);
  }

  private Limits limits() {
    return Limits.of(settings.current()).within(authority().limits());
  }

  private Authority authority() {
    return output.authority();
  }
}
