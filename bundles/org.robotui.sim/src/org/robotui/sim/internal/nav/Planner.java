package org.robotui.sim.internal.nav;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.PriorityQueue;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** A* on the grid, which prefers the middle of the free space. For one thread. */
public final class Planner {
  private static final double COMFORT = 0.75;
  private static final double DISCOMFORT_COST = 4;
  private static final double ESCAPE_RADIUS = 0.5;
  private static final double ESCAPE_COST = 20;

  private final Clearance clearance;
  private final GridMap map;
  private final double radius;
  private final PathSmoother smoother;

  /** @param radius of the robot with its margin, metres */
  public Planner(Clearance clearance, double radius) {
    this.clearance = clearance;
    this.radius = radius;
    map = clearance.map();
    smoother = new PathSmoother(clearance, radius);
  }

  /** Plans a way between two poses in the map. */
  public Plan plan(Pose2 start, Pose2 goal) {
    if (clearance.atPoint(start.x(), start.y()) == 0) {
      return new Plan.Impossible("the robot is not on free ground in the map");
    }
    if (clearance.atPoint(goal.x(), goal.y()) < radius) {
      return new Plan.Impossible("the goal is too close to an obstacle, or off the map");
    }
    Search search = new Search(cell(start), cell(goal));
    return search.run()
        ? new Plan.Found(smoother.smooth(start, goal, search.way()))
        : new Plan.Impossible("no path leads to the goal");
  }

  private int cell(Pose2 pose) {
    return map.row(pose.y()) * map.width() + map.column(pose.x());
  }

  private record Open(int cell, double estimate) {}

  /** One run of the search. */
  private final class Search {
    private final int start;
    private final int goal;
    private final double[] costs = new double[map.width() * map.height()];
    private final int[] parents = new int[map.width() * map.height()];
    private final boolean[] closed = new boolean[map.width() * map.height()];
    private final PriorityQueue<Open> open =
        new PriorityQueue<>((a, b) -> Double.compare(a.estimate(), b.estimate()));

    Search(int start, int goal) {
      this.start = start;
      this.goal = goal;
      Arrays.fill(costs, Double.POSITIVE_INFINITY);
    }

    boolean run() {
      costs[start] = 0;
      parents[start] = start;
      open.add(new Open(start, distance(start, goal)));
      while (!open.isEmpty() && !closed[goal]) {
        int cell = open.remove().cell();
        if (!closed[cell]) {
          closed[cell] = true;
          expand(cell);
        }
      }
      return closed[goal];
    }

    private void expand(int cell) {
      for (int dr = -1; dr <= 1; dr++) {
        for (int dc = -1; dc <= 1; dc++) {
          int column = cell % map.width() + dc;
          int row = cell / map.width() + dr;
          double weight = weight(column, row);
          if (weight < Double.POSITIVE_INFINITY) {
            relax(cell, row * map.width() + column, weight * Math.hypot(dc, dr));
          }
        }
      }
    }

    private void relax(int from, int to, double step) {
      double cost = costs[from] + step;
      if (!closed[to] && cost < costs[to]) {
        costs[to] = cost;
        parents[to] = from;
        open.add(new Open(to, cost + distance(to, goal)));
      }
    }

    /** Cost per cell; a robot that stands too close to something may still drive away from it. */
    private double weight(int column, int row) {
      double room = clearance.at(column, row);
      if (room >= radius) {
        double crowding = Math.max(0, (COMFORT - room) / COMFORT);
        return 1 + DISCOMFORT_COST * crowding * crowding;
      }
      int cell = row * map.width() + column;
      boolean escape = room > 0 && distance(cell, start) * map.resolution() < ESCAPE_RADIUS;
      return escape ? ESCAPE_COST : Double.POSITIVE_INFINITY;
    }

    private double distance(int a, int b) {
      return Math.hypot(a % map.width() - b % map.width(), a / map.width() - b / map.width());
    }

    List<Pose2> way() {
      Deque<Pose2> way = new ArrayDeque<>();
      for (int cell = goal; cell != start; cell = parents[cell]) {
        way.addFirst(new Pose2(map.centreX(cell % map.width()), map.centreY(cell / map.width()), 0));
      }
      return new ArrayList<>(way);
    }
  }
}
