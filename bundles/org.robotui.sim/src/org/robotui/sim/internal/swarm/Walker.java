package org.robotui.sim.internal.swarm;

import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;

/**
 * One robot of a swarm: a disc that drives to goals, keeps off from what is near, and does as it is told. All of it is
 * for the one thread that lets time pass, but for the commands.
 */
final class Walker {
  /** Metres. */
  static final double RADIUS = 0.25;

  private static final double SPEED = 0.6;
  private static final double TURN = 1.5;
  private static final double GAIN = 2.5;
  private static final double ACCELERATION = 1.2;
  private static final double NEAR = 0.9;
  private static final double ARRIVED = 0.15;
  private static final double PATIENCE = 0.6;
  private static final double CAPACITY_SECONDS = 3600;
  private static final double GIVE_UP_SECONDS = 20;

  /** What it does. */
  enum Task {
    /** Nothing. */
    STANDING,
    /** It drives to places of its own choice. */
    PATROLLING,
    /** It drives to a goal that it was given. */
    GOING,
    /** It got there. */
    ARRIVED,
    /** It did not get there. */
    GAVE_UP,
    /** Somebody drives it. */
    DRIVEN
  }

  /** A place to drive to, metres. */
  record Goal(double x, double y) {}

  /** What it was told. */
  private sealed interface Order {
    /** To drive. */
    record Drive(double linear, double angular) implements Order {}

    /** To go to a place. */
    record Go(Goal goal) implements Order {}
  }

  private final Hall hall;
  private final RandomGenerator random;
  private volatile Optional<Order> order = Optional.empty();
  private Task task = Task.PATROLLING;
  private Optional<Goal> goal = Optional.empty();
  private double x;
  private double y;
  private double yaw;
  private double linear;
  private double angular;
  private double toldLinear;
  private double toldAngular;
  private double driven;
  private double blocked;
  private double charge;

  Walker(Hall hall, double x, double y, RandomGenerator random) {
    this.hall = hall;
    this.random = random;
    this.x = x;
    this.y = y;
    this.yaw = random.nextDouble(-Math.PI, Math.PI);
    this.charge = random.nextDouble(0.3, 1);
  }

  /** Any thread. What it did before is over, also for a zero. */
  void drive(double forward, double turn) {
    order = Optional.of(new Order.Drive(Math.clamp(forward, -SPEED, SPEED), Math.clamp(turn, -TURN, TURN)));
  }

  /** Any thread. */
  void go(Goal where) {
    order = Optional.of(new Order.Go(where));
  }

  void step(double seconds, List<Walker> all) {
    order.ifPresent(this::take);
    order = Optional.empty();
    double[] wanted = wanted(seconds, all);
    linear = approach(linear, wanted[0], ACCELERATION * seconds);
    angular = approach(angular, wanted[1], 4 * ACCELERATION * seconds);
    yaw = wrap(yaw + angular * seconds);
    move(seconds, all);
    charge = Math.max(0, charge - seconds * (0.3 + Math.abs(linear)) / CAPACITY_SECONDS);
  }

  private void take(Order told) {
    switch (told) {
      case Order.Drive d -> {
        task = Task.DRIVEN;
        goal = Optional.empty();
        toldLinear = d.linear();
        toldAngular = d.angular();
        driven = 0;
      }
      case Order.Go g -> {
        task = Task.GOING;
        goal = Optional.of(g.goal());
        blocked = 0;
      }
    }
  }

  private double[] wanted(double seconds, List<Walker> all) {
    return switch (task) {
      case STANDING, ARRIVED, GAVE_UP -> new double[2];
      case DRIVEN -> asTold(seconds);
      case GOING -> toGoal(seconds, all);
      case PATROLLING -> {
        goal = goal.or(() -> Optional.of(somewhere()));
        yield toGoal(seconds, all);
      }
    };
  }

  /** As told, until nobody tells it any more. */
  private double[] asTold(double seconds) {
    driven += seconds;
    if (driven > PATIENCE) {
      task = Task.STANDING;
    }
    return driven > PATIENCE ? new double[2] : new double[]{toldLinear, toldAngular};
  }

  private double[] toGoal(double seconds, List<Walker> all) {
    Goal to = goal.orElseThrow();
    double left = Math.hypot(to.x() - x, to.y() - y);
    boolean over = blocked > (task == Task.GOING ? GIVE_UP_SECONDS : 3);
    if (left < ARRIVED || over) {
      goal = Optional.empty();
      blocked = 0;
      task = task == Task.PATROLLING ? Task.PATROLLING : over ? Task.GAVE_UP : Task.ARRIVED;
      return new double[2];
    }
    double[] way = {(to.x() - x) / left, (to.y() - y) / left};
    avoid(way, all);
    double off = wrap(Math.atan2(way[1], way[0]) - yaw);
    double speed = Math.abs(off) > 1 ? 0 : Math.min(SPEED, 0.15 + left) * Math.cos(off);
    blocked = Math.abs(linear) < 0.05 ? blocked + seconds : 0;
    return new double[]{speed, Math.clamp(GAIN * off, -TURN, TURN)};
  }

  /** Turns the way off from what is near, to the right of those who come. */
  private void avoid(double[] way, List<Walker> all) {
    for (Walker other : all) {
      if (other != this) {
        push(way, other.x, other.y, RADIUS);
      }
    }
    hall.pillars().forEach(p -> push(way, p.x(), p.y(), p.radius()));
  }

  private void push(double[] way, double ox, double oy, double radius) {
    double dx = x - ox;
    double dy = y - oy;
    double gap = Math.hypot(dx, dy) - radius - RADIUS;
    if (gap < NEAR) {
      double strength = (NEAR - Math.max(gap, 0.02)) / NEAR / Math.max(0.05, Math.hypot(dx, dy));
      way[0] += strength * (dx + 0.8 * dy);
      way[1] += strength * (dy - 0.8 * dx);
    }
  }

  private void move(double seconds, List<Walker> all) {
    double nextX = x + linear * seconds * Math.cos(yaw);
    double nextY = y + linear * seconds * Math.sin(yaw);
    boolean free = hall.isFree(nextX, nextY, RADIUS)
        && all.stream().noneMatch(o -> o != this && closer(o, nextX, nextY));
    if (free) {
      x = nextX;
      y = nextY;
    } else {
      linear = 0;
    }
  }

  private boolean closer(Walker other, double nextX, double nextY) {
    double next = Math.hypot(other.x - nextX, other.y - nextY);
    return next < 2 * RADIUS && next < Math.hypot(other.x - x, other.y - y);
  }

  private Goal somewhere() {
    return new Goal(random.nextDouble(1.5, hall.width() - 1.5), random.nextDouble(1.5, Hall.HEIGHT - 1.5));
  }

  /** What each of some beams all around meets, from the front on, counter-clockwise, metres. */
  float[] scan(int beams, List<Walker> all) {
    List<Walker> near =
        all.stream().filter(o -> o != this && Math.hypot(o.x - x, o.y - y) < Hall.SIGHT + RADIUS).toList();
    float[] ranges = new float[beams];
    for (int i = 0; i < beams; i++) {
      double angle = yaw + 2 * Math.PI * i / beams;
      double nearest = hall.range(x, y, angle);
      for (Walker o : near) {
        nearest = Math.min(nearest, Hall.toDisc(o.x - x, o.y - y, Math.cos(angle), Math.sin(angle), RADIUS));
      }
      ranges[i] = (float) (nearest > Hall.SIGHT ? Double.POSITIVE_INFINITY : nearest);
    }
    return ranges;
  }

  private static double approach(double from, double to, double most) {
    return from + Math.clamp(to - from, -most, most);
  }

  private static double wrap(double angle) {
    return Math.IEEEremainder(angle, 2 * Math.PI);
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  double yaw() {
    return yaw;
  }

  double linear() {
    return linear;
  }

  double angular() {
    return angular;
  }

  /** From 0 to 1. */
  double charge() {
    return charge;
  }

  Task task() {
    return task;
  }

  /** Where it drives to, where it does. */
  Optional<Goal> goal() {
    return goal;
  }
}
