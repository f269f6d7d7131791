package org.robotui.sim.internal;

import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.function.Consumer;
import org.robotui.sim.internal.Event.Severity;
import org.robotui.sim.internal.RobotState.BatteryReading;
import org.robotui.sim.internal.nav.Clearance;
import org.robotui.sim.internal.nav.FrontGuard;
import org.robotui.sim.internal.nav.Navigator;
import org.robotui.sim.internal.nav.Planner;
import org.robotui.sim.internal.robot.Battery;
import org.robotui.sim.internal.robot.Body;
import org.robotui.sim.internal.robot.DriveTrain;
import org.robotui.sim.internal.robot.Localisation;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.robot.WheelOdometry;
import org.robotui.sim.internal.sensor.Imu;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.Walker;
import org.robotui.sim.internal.world.World;

/**
 * The robot in its building, advanced in steps of {@link #STEP} seconds by one thread. The same seed, steps and commands
 * give the same states. {@link #submit} and {@link #state} are for any thread.
 */
public final class Simulation {
  public static final double STEP = 0.01;
  private static final int NAVIGATION_STEPS = 5;
  private static final int LOCALISATION_STEPS = 20;
  private static final double DOCK_RADIUS = 0.35;
  private static final double PLANNING_RADIUS = Body.RADIUS + 0.08;
  private static final double BUMP_SILENCE = 2;

  private final World world;
  private final Settings settings;
  private final Consumer<Event> events;
  private final Queue<Command> commands = new ArrayBlockingQueue<>(256);
  private final DriveTrain drive;
  private final Body body;
  private final WheelOdometry odometry;
  private final Localisation localisation;
  private final Battery battery;
  private final Imu imu;
  private final Pilot pilot;
  private final FrontGuard guard;
  private final Optional<Walker> walker;
  private World present;
  private Tuning tuning;
  private long steps;
  private boolean motorsOn = true;
  private boolean bumped;
  private double quietUntil;
  private int resets;
  private volatile RobotState state;

  /** @param events called by the stepping thread */
  public Simulation(World world, GridMap map, Settings settings, Consumer<Event> events) {
    this.world = world;
    this.settings = settings;
    this.events = events;
    present = world;
    walker = world.walk().isEmpty() ? Optional.empty() : Optional.of(new Walker(world.walk()));
    walker.ifPresent(person -> present = world.with(Walker.body(person.place())));
    drive = new DriveTrain(settings.limits());
    body = new Body(this::present, world.start());
    odometry = new WheelOdometry(settings.odometryErrors(), random(1));
    localisation = new Localisation(random(2), world.start());
    battery = new Battery(settings.batteryLevel());
    imu = new Imu(random(3));
    tuning = Tuning.of(settings.limits());
    pilot = new Pilot(new Navigator(new Planner(new Clearance(map), PLANNING_RADIUS), tuning.cruise()), events);
    guard = new FrontGuard(this::present, Body.RADIUS, settings.laser().height());
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
    return commands.offer(command);
  }

  public RobotState state() {
    return state;
  }

  /** Advances by one step. */
  public void step() {
    steps++;
    for (Command command = commands.poll(); command != null; command = commands.poll()) {
      apply(command);
    }
    pilot.expire(now());
    walker.filter(person -> tuning.personWalks()).ifPresent(this::walk);
    if (steps % NAVIGATION_STEPS == 0) {
      navigate();
    }
    move();
    if (steps % LOCALISATION_STEPS == 0) {
      boolean moving = !drive.speed().isZero();
      localisation.update(body.pose(), odometry.pose(), STEP * LOCALISATION_STEPS, moving);
    }
    state = capture();
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
    Speed speed = drive.approach(powered ? pilot.wish() : Speed.ZERO, STEP);
    Pose2 before = body.pose();
    boolean free = body.move(speed.linear() * STEP, speed.angular() * STEP);
    if (!free) {
      drive.block();
      reportBump();
    }
    bumped = !free || bumped && body.pose().equals(before);
    odometry.moved(free ? speed.linear() * STEP : 0, speed.angular() * STEP);
    imu.update(drive.speed(), STEP);
    useBattery();
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
    pilot.navigate(estimate(), room, STEP * NAVIGATION_STEPS);
  }

  private Pose2 estimate() {
    return localisation.estimate(odometry.pose());
  }

  private void apply(Command command) {
    switch (command) {
      case Command.Drive wish -> pilot.drive(wish.speed(), now());
      case Command.Goal goal -> pilot.goTo(goal.id(), goal.pose(), estimate());
      case Command.Cancel cancel -> pilot.cancel(cancel.id());
      case Command.Tune tune -> tune(tune.tuning());
      case Command.InitialPose initial -> believe(initial.pose());
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
    odometry.reset();
    localisation.set(world.start(), odometry.pose());
    battery.refill(settings.batteryLevel());
    motorsOn = true;
    bumped = false;
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
        odometry.leftAngle(), odometry.rightAngle(), reading, motorsOn, localisation.isLost(), bumped,
        pilot.goal(), pilot.path(), pilot.status(), tuning, walker.map(Walker::place), resets);
  }
}
