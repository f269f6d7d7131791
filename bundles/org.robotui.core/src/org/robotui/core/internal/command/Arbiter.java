package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Accepted;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.CommandOutcome.Why;
import org.robotui.api.command.Principal;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.RelayMessage;

/**
 * Decides who may command one robot, and stops what must not go on. Deciding never blocks: sending is done by the
 * senders of the robot's interfaces. What depends on time happens in {@link #step}, which a thread of its own calls.
 */
public final class Arbiter implements Authority {
  private static final Duration LONGEST = Duration.ofHours(1);

  private final String robot;
  private final NanoClock clock;
  private final DisplayWatch display;
  private final Runnable wake;
  private final StopListener stops;
  private final List<RobotPorts> ports = new CopyOnWriteArrayList<>();
  private final Map<CommandTarget<?>, Drive> drives = new LinkedHashMap<>();
  private Optional<Principal> holder = Optional.empty();
  private Optional<Principal> stopper = Optional.empty();
  private Optional<LatchedStop> latched = Optional.empty();
  /**
   * Motion ports on which something was driven from here: their stop is ours to bring about, also when they were made
   * anew.
   */
  private final Set<SourceId> driven = new HashSet<>();

  /**
   * An arbiter.
   *
   * @param robot its name
   * @param clock monotonic
   * @param display whether the user sees what moves
   * @param wake has {@link #step} called soon
   */
  public Arbiter(String robot, NanoClock clock, DisplayWatch display, Runnable wake) {
    this(robot, clock, display, wake, StopListener.NONE);
  }

  /** An arbiter of whose stops somebody hears. */
  Arbiter(String robot, NanoClock clock, DisplayWatch display, Runnable wake, StopListener stops) {
    this.stops = stops;
    this.robot = robot;
    this.clock = clock;
    this.display = display;
    this.wake = wake;
  }

  /** A RUIC has interfaces to this robot. */
  public void register(RobotPorts of) {
    ports.add(of);
    wake.run();
  }

  /** They have ended. */
  public void unregister(RobotPorts of) {
    ports.remove(of);
  }

  boolean isUsed() {
    return !ports.isEmpty();
  }

  /** Has {@link #step} called, since a link or the focus has changed. */
  public void recheck() {
    wake.run();
  }

  /** Decides on a command and gives it to the sender. */
  <T extends Data> CommandOutcome send(
      Object output, Principal principal, CommandTarget<T> target, T command, Duration validFor) {
    CommandOutcome outcome = decide(output, principal, target, command, validFor);
    wake.run();
    return outcome;
  }

  private synchronized <T extends Data> CommandOutcome decide(
      Object output, Principal principal, CommandTarget<T> target, T command, Duration validFor) {
    return obstacle(principal, target, command, validFor).<CommandOutcome>map(r -> r).orElseGet(() -> {
      Duration valid = validFor.compareTo(LONGEST) < 0 ? validFor : LONGEST;
      long deadline = clock.nanos() + valid.toNanos();
      if (!target.post(limited(command), deadline)) {
        return new Refused(Why.ROBOT, target.id() + " is too slow: too many commands wait");
      }
      track(output, principal, target, command, deadline);
      return new Accepted();
    });
  }

  private Optional<Refused> obstacle(Principal principal, CommandTarget<?> target, Data command, Duration validFor) {
    if (target.isClosed()) {
      return refused(Why.NOT_CONNECTED, target.id() + " is not offered any more");
    }
    if (!target.fence().isEmpty()) {
      return refused(Why.ROBOT, target.fence());
    }
    if (!target.link().isUp()) {
      return refused(Why.LINK_DOWN, "no link to " + robot + " (" + target.link().text() + ")");
    }
    if (!validFor.isPositive()) {
      return refused(Why.EXPIRED, "the command was too old");
    }
    return command instanceof RelayMessage relayed && !relayed.guarded() ? Optional.empty() : notAllowed(principal);
  }

  /** Why a principal may not command this robot now. */
  public synchronized Optional<Refused> notAllowed(Principal principal) {
    if (stopper.isPresent()) {
      return refused(Why.STOPPED, robot + " is stopped by " + stopper.get().label() + "; release the stop first");
    }
    Optional<String> unattended = unattended(principal);
    return unattended.isPresent() ? refused(Why.DISPLAY_SILENT, unattended.get()) : noLease(principal);
  }

  private Optional<String> unattended(Principal principal) {
    return principal.kind() == Principal.Kind.WINDOW ? display.unattended() : Optional.empty();
  }

  private Optional<Refused> noLease(Principal principal) {
    if (holder.filter(h -> !h.equals(principal)).isPresent()) {
      return refused(Why.NO_LEASE, holder.get().label() + " has control of " + robot + "; take it over first");
    }
    boolean needed = ports.isEmpty() || ports.stream().anyMatch(p -> p.safety().leaseNeeded());
    return holder.isEmpty() && needed
        ? refused(Why.NO_LEASE, "nobody has control of " + robot + "; take control first")
        : Optional.empty();
  }

  private static Optional<Refused> refused(Why why, String explanation) {
    return Optional.of(new Refused(why, explanation));
  }

  @SuppressWarnings("unchecked") // a Motion within limits is of its own type by contract
  private <T extends Data> T limited(T command) {
    return command instanceof Motion<?> motion ? (T) motion.within(limits()) : command;
  }

  @Override
  public MotionLimits limits() {
    return ports.stream().map(p -> p.safety().limits()).reduce(MotionLimits.NONE, MotionLimits::and);
  }

  private void track(Object output, Principal principal, CommandTarget<?> target, Data command, long deadline) {
    if (command instanceof Motion<?> motion && !motion.equals(motion.stopped())) {
      driven.add(target.id());
      Drive drive = drives.get(target);
      if (drive != null && !drive.linkLost()) {
        drive.renew(output, principal, deadline);
      } else {
        drives.put(target, new Drive(target, output, principal, deadline));
      }
    } else if (command instanceof Motion<?>) {
      // A commanded zero is repeated like any other, since the one datagram that carries it may be lost.
      Optional.ofNullable(drives.get(target)).ifPresent(d -> d.end(clock.nanos()));
    }
  }

  /** Ends what an output moves. */
  void release(Object output) {
    endDrives(d -> d.isOf(output));
  }

  private void endDrives(Predicate<Drive> which) {
    synchronized (this) {
      drives.values().stream().filter(which).forEach(d -> d.end(clock.nanos()));
    }
    wake.run();
  }

  /**
   * Stops what we move on these ports, before they close; they take no command after it. What we do not move is not
   * touched.
   *
   * @return the ports on which something moved
   */
  public synchronized List<CommandTarget<?>> endNow(List<CommandTarget<?>> targets) {
    targets.forEach(CommandTarget::takeNoMore);
    List<CommandTarget<?>> ours = targets.stream().filter(drives::containsKey).toList();
    ours.forEach(drives::remove);
    ours.forEach(CommandTarget::postZero);
    return ours;
  }

  /** A port has gone. */
  synchronized void forget(CommandTarget<?> target) {
    drives.remove(target);
  }

  /** Whether we move something there. */
  synchronized boolean drives(CommandTarget<?> target) {
    return drives.containsKey(target);
  }

  /** Does what time demands. Returns when to be called again at the latest, by the monotonic clock. */
  public synchronized long step() {
    long now = clock.nanos();
    long next = latched.map(l -> l.step(now, motionPorts(), streams())).orElse(Long.MAX_VALUE);
    for (Iterator<Drive> all = drives.values().iterator(); all.hasNext();) {
      Drive drive = all.next();
      if (drive.isMoving() && mustEnd(drive, now)) {
        end(drive, now);
      }
      if (!drive.isMoving() && drive.zeroed(now)) {
        all.remove();
      } else {
        next = Math.min(next, deadline(drive));
      }
    }
    return next;
  }

  private void end(Drive drive, long now) {
    drive.end(now);
    if (drive.principal().kind() == Principal.Kind.WINDOW && display.isSilent()) {
      display.stoppedSomething();
    }
  }

  private boolean mustEnd(Drive drive, long now) {
    return drive.expired(now) || drive.linkLost() || notAllowed(drive.principal()).isPresent();
  }

  private long deadline(Drive drive) {
    boolean watched = drive.isMoving() && drive.principal().kind() == Principal.Kind.WINDOW;
    return watched ? Math.min(drive.nextDeadline(), display.silentAtNanos()) : drive.nextDeadline();
  }

  private List<CommandTarget<?>> motionPorts() {
    List<CommandTarget<?>> all = new ArrayList<>();
    ports.forEach(p -> p.commands().stream().filter(t -> t.port().isMotion()).forEach(all::add));
    return all;
  }

  private List<StreamSource<?>> streams() {
    return ports.stream().flatMap(p -> p.streams().stream()).toList();
  }

  void report(String message) {
    ports.forEach(p -> p.alert(message));
  }

  private void changed() {
    wake.run();
    ports.forEach(RobotPorts::changed);
  }

  @Override
  public String robot() {
    return robot;
  }

  @Override
  public synchronized Optional<Principal> holder() {
    return holder;
  }

  @Override
  public LeaseOutcome take(Principal principal, boolean takeover) {
    synchronized (this) {
      if (!takeover && holder.filter(h -> !h.equals(principal)).isPresent()) {
        return new LeaseOutcome.HeldBy(holder.get());
      }
      holder = Optional.of(principal);
      drives.values().stream().filter(d -> !d.principal().equals(principal)).forEach(d -> d.end(clock.nanos()));
    }
    changed();
    return new LeaseOutcome.Granted();
  }

  @Override
  public void giveBack(Principal principal) {
    synchronized (this) {
      if (holder.filter(principal::equals).isEmpty()) {
        return;
      }
      holder = Optional.empty();
      drives.values().stream().filter(d -> d.principal().equals(principal)).forEach(d -> d.end(clock.nanos()));
    }
    changed();
  }

  @Override
  public void stop(Principal by) {
    synchronized (this) {
      stopper = Optional.of(by);
      latched = Optional.of(new LatchedStop(driven));
      drives.values().forEach(d -> d.end(clock.nanos()));
      ports.forEach(p -> p.commands().forEach(CommandTarget::clear));
    }
    wake.run(); // before all that needs memory or time
    stops.stopped(robot, by);
    ports.forEach(RobotPorts::cancelCalls);
    ports.forEach(RobotPorts::callStop);
    changed();
  }

  /** Stops as well, and says what that ended. */
  String stopAndTell(Principal by) {
    Optional<Principal> before;
    List<String> moved;
    synchronized (this) {
      before = stopper;
      moved = drives.values().stream().filter(Drive::isMoving).map(d -> d.target().id().toString()).sorted().toList();
    }
    stop(by);
    String what =
        moved.isEmpty() ? "nothing was driven from here" : "what was driven from here: " + String.join(", ", moved);
    return robot + " is stopped (" + before.map(b -> "it was already, by " + b.label()).orElse(what) + ")";
  }

  @Override
  public void releaseStop(Principal by) {
    synchronized (this) {
      stopper = Optional.empty();
      latched = Optional.empty();
    }
    stops.released(robot);
    changed();
  }

  @Override
  public synchronized Optional<Principal> stoppedBy() {
    return stopper;
  }
}
