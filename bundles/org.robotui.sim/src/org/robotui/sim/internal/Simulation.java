package org.robotui.sim.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.function.Consumer;
import org.robotui.sim.internal.Event.Severity;
import org.robotui.sim.internal.RobotState.BatteryReading;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.nav.Clearance;
import org.robotui.sim.internal.nav.FrontGuard;
import org.robotui.sim.internal.nav.Navigator;
import org.robotui.sim.internal.nav.Planner;
import org.robotui.sim.internal.robot.Battery;
import org.robotui.sim.internal.robot.Body;
import org.robotui.sim.internal.robot.DriveTrain;
import org.robotui.sim.internal.robot.Localisation;
import org.robotui.sim.internal.robot.Neck;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.robot.WheelOdometry;
import org.robotui.sim.internal.sensor.BumperRing;
import org.robotui.sim.internal.sensor.Imu;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.Walker;
import org.robotui.sim.internal.world.World;

/**
 * The robot in its building, advanced in steps of {@link #STEP} seconds by one thread. The same seed, steps and
 * commands give the same states. {@link #submit} and {@link #state} are for any thread.
 */
public final class Simulation {
  public static final double STEP = 0.01;
  private static final int NAVIGATION_STEPS = 5;
  private static final int LOCALISATION_STEPS = 20;
  private static final double DOCK_RADIUS = 0.35;
  private static final double PLANNING_MARGIN = 0.08;
  private static final double BUMP_SILENCE = 2;

  private final World world;
  private final Settings settings;
  private final Consumer<Event> events;
  private final RobotModel robot;
  private final Queue<Order> commands = new ArrayBlockingQueue<>(256);
  private final DriveTrain drive;
  private final Body body;
  private final WheelOdometry odometry;
  private final Localisation localisation;
  private final Battery battery;
  private final Imu imu;
  private final BumperRing bumpers;
  private final Optional<Neck> neck;
  private final Pilot pilot;
  private final FrontGuard guard;
  private final Optional<Walker> walker;
  private World present;
  private Tuning tuning;
  private long steps;
  private boolean motorsOn = true;
  private boolean bumped;
  private List<Boolean> pressed;
  private double quietUntil;
  private int resets;
  private volatile RobotState state;

  /** @param events called by the stepping thread */
  public Simulation(World world, GridMap map, Settings settings, Consumer<Event> events) {
    this.world = world;
    this.settings = settings;
    robot = settings.robot();
    this.events = events;
    present = world;
    walker = world.walk().isEmpty() ? Optional.empty() : Optional.of(new Walker(world.walk()));
    walker.ifPresent(person -> present = world.with(Walker.body(person.place())));
    drive = new DriveTrain(settings.limits());
    body = new Body(this::present, world.start(), robot.radius(), robot.height());
    odometry = new WheelOdometry(robot.odometryErrors(), robot.wheels(), random(1));
    localisation = new Localisation(random(2), world.start());
    battery = new Battery(settings.batteryLevel());
    imu = new Imu(random(3));
    bumpers = new BumperRing(robot.bumpers(), robot.radius(), robot.height());
    pressed = bumpers.free();
    neck = robot.head() ? Optional.of(new Neck()) : Optional.empty();
    tuning = Tuning.of(settings.limits());
    pilot = new Pilot(new Navigator(new Planner(new Clearance(map), robot.radius() + PLANNING_MARGIN), tuning.cruise()),
        events);
    guard = new FrontGuard(this::present, robot.radius(), robot.laser().height());
    state = capture();
  }

  /** A source of noise of its own for each part, so that using one does not change another. */
  public Random random(int part) {
    return new Random(settings.seed() * 1000003 + part);
  }

  public World world() {
    return world;
  }

  /** The building with everybody in it at this moment. For the stepping thread only. */
  public World present() {
    return present;
  }

  public Settings settings() {
    return settings;
  }

  /** For the stepping thread only. */
  public Imu imu() {
    return imu;
  }

  /** Asks for something with the next step; false if more was asked than can be done. */
  public boolean submit(Command command) {
    return submit(command, () -> {});
  }

  /**
   * Asks for something with the next step.
   *
   * @param done called by the stepping thread when it was done and the state shows it
   * @return false if more was asked than can be done
   */
  public boolean submit(Command command, Runnable done) {
    return commands.offer(new Order(command, done));
  }

  private record Order(Command command, Runnable done) {}

  public RobotState state() {
    return state;
  }

  /** Advances by one step. */
  public void step() {
    steps++;
    List<Runnable> done = new ArrayList<>();
    for (Order order = commands.poll(); order != null; order = commands.poll()) {
      apply(order.command());
      done.add(order.done());
    }
    pilot.expire(now());
    walker.filter(person -> tuning.personWalks()).ifPresent(this::walk);
    if (steps % NAVIGATION_STEPS == 0) {
      navigate();
    }
    neck.ifPresent(moving -> moving.step(now(), STEP));
    move();
    if (steps % LOCALISATION_STEPS == 0) {
      boolean moving = !drive.speed().isZero();
      localisation.update(body.pose(), odometry.pose(), STEP * LOCALISATION_STEPS, moving);
    }
    state = capture();
    done.forEach(Runnable::run);
  }

  private void walk(Walker person) {
    person.step(body.pose(), STEP);
    present = world.with(Walker.body(person.place()));
  }

  private double now() {
    return steps * STEP;
  }

  private void move() {
    boolean powered = motorsOn && !battery.isEmpty();
    Speed speed = drive.approach(powered ? held(pilot.wish()) : Speed.ZERO, STEP);
    Pose2 before = body.pose();
    boolean free = body.move(speed.linear() * STEP, speed.angular() * STEP);
    if (!free) {
      drive.block();
      reportBump();
    }
    feel(free);
    bumped = !free || pressed.contains(true) || bumped && body.pose().equals(before);
    odometry.moved(free ? speed.linear() * STEP : 0, speed.angular() * STEP);
    imu.update(drive.speed(), STEP);
    useBattery();
  }

  /** With a bumper pressed it only backs off and turns. */
  private Speed held(Speed wish) {
    return pressed.contains(true) && wish.linear() > 0 ? new Speed(0, wish.angular()) : wish;
  }

  private void feel(boolean free) {
    boolean before = pressed.contains(true);
    pressed = free && !before ? bumpers.free() : bumpers.touch(present, body.pose());
    if (pressed.contains(true) && !before) {
      pilot.blocked("a bumper is pressed");
    }
  }

  private void useBattery() {
    boolean flatBefore = battery.isEmpty();
    battery.use(drive.speed(), body.pose().distanceTo(world.start()) < DOCK_RADIUS, STEP);
    if (battery.isEmpty() && !flatBefore) {
      report(Severity.ERROR, "battery", "the battery is empty: motors off, call reset");
    }
  }

  private void reportBump() {
    if (now() >= quietUntil) {
      Pose2 at = body.pose();
      report(Severity.WARN, "base", String.format(Locale.ROOT, "bumped into something at %.2f, %.2f", at.x(), at.y()));
    }
    quietUntil = now() + BUMP_SILENCE;
  }

  private void navigate() {
    double room = pilot.goal().isPresent() ? guard.room(body.pose()) : 0;
    pilot.navigate(estimate(), odometry.pose(), room, STEP * NAVIGATION_STEPS);
  }

  private Pose2 estimate() {
    return localisation.estimate(odometry.pose());
  }

  private void apply(Command command) {
    switch (command) {
      case Command.Drive wish -> pilot.drive(wish.speed(), now() + wish.hold());
      case Command.Approach there -> pilot.approach(there.pose(), there.most());
      case Command.Goal goal -> pilot.goTo(goal.id(), goal.pose(), estimate());
      case Command.Cancel cancel -> pilot.cancel(cancel.id());
      case Command.Tune tune -> tune(tune.tuning());
      case Command.InitialPose initial -> believe(initial.pose());
      case Command.SetOdometry set -> setOdometry(set.pose());
      case Command.Turn turn -> neck.ifPresent(moving -> moving.look(turn.look()));
      case Command.Motors motors -> switchMotors(motors.on());
      case Command.Stop stop -> pilot.stop("stopped");
      case Command.Reset reset -> reset();
    }
  }

  private void believe(Pose2 pose) {
    localisation.set(pose, odometry.pose());
    report(Severity.INFO, "localisation",
        String.format(Locale.ROOT, "initial pose set: %.2f, %.2f", pose.x(), pose.y()));
    pilot.relocalised(pose);
  }

  private void setOdometry(Pose2 pose) {
    Pose2 estimate = estimate();
    odometry.set(pose);
    localisation.set(estimate, pose);
  }

  private void tune(Tuning wish) {
    tuning = wish;
    drive.limit(wish.limits());
    pilot.cruise(wish.cruise());
    report(Severity.INFO, "base", String.format(Locale.ROOT, "limits set to %.2f m/s and %.2f rad/s, driving %s",
        wish.limits().linear(), wish.limits().angular(), wish.style().name().toLowerCase(Locale.ROOT)));
  }

  private void switchMotors(boolean on) {
    motorsOn = on;
    report(Severity.INFO, "base", on ? "motors on" : "motors off");
  }

  private void reset() {
    pilot.stop("reset to the start");
    drive.halt();
    body.place(world.start());
    odometry.set(Pose2.ORIGIN);
    localisation.set(world.start(), odometry.pose());
    battery.refill(settings.batteryLevel());
    motorsOn = true;
    bumped = false;
    pressed = bumpers.free();
    neck.ifPresent(Neck::release);
    resets++;
  }

  private void report(Severity severity, String source, String text) {
    events.accept(new Event(severity, source, text));
  }

  private RobotState capture() {
    BatteryReading reading = new BatteryReading(
        battery.level(), battery.charge(), battery.voltage(), battery.current(), battery.isCharging());
    return new RobotState(
        now(), body.pose(), odometry.pose(), localisation.mapFromOdometry(), drive.speed(),
        odometry.leftAngle(), odometry.rightAngle(), reading, motorsOn, localisation.isLost(), bumped, pressed,
        neck.map(Neck::head), pilot.goal(), pilot.path(), pilot.status(), tuning, walker.map(Walker::place), resets);
  }
}
