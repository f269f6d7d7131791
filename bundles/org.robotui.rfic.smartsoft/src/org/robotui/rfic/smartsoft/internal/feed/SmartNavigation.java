package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Offer;
import org.robotui.api.port.StreamPort;
import org.robotui.api.session.AskedStream;
import org.robotui.api.session.PlaceCommands;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.net.thread.Workers;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.SmartPattern;

/**
 * Maps that are answered to queries, as streams, and planners, whose goals are parameters, as commands. Used by the
 * thread that follows, but for halting and closing.
 */
public final class SmartNavigation implements AutoCloseable {
  private static final String MAP_REQUEST = "CommNavigationObjects::CommGridMapRequest";
  private static final String PLANNER_GOAL = "CommNavigationObjects::CommPlannerGoal";
  private static final Duration PACE = Duration.ofSeconds(2);
  private static final Duration END = Duration.ofMillis(700);

  private final SmartShared shared;
  private final SmartServices services;
  private final Workers workers;
  private final Map<String, AskedStream<GridMap>> maps = new TreeMap<>(); // guarded by this, as the following
  private final Map<String, PlaceCommands<NavigationGoal>> planners = new TreeMap<>();
  private final Map<String, Offer> offers = new TreeMap<>();
  private boolean closed;

  public SmartNavigation(SmartShared shared, SmartServices services) {
    this.shared = shared;
    this.services = services;
    this.workers = new Workers(shared.context().threads());
  }

  /** Offers what is there now. */
  public synchronized void look() {
    if (closed) {
      return;
    }
    services.of(SmartPattern.QUERY, MAP_REQUEST).keySet().forEach(path -> maps.computeIfAbsent(path, this::map));
    services.of(SmartPattern.PUSH, PLANNER_GOAL).values().stream().map(service -> service.name().component())
        .forEach(component -> parameters(component).ifPresent(path -> planner(component, path)));
  }

  private AskedStream<GridMap> map(String path) {
    return new AskedStream<>(shared.context(), new StreamPort<>(path, GridMap.class, Arity.MANY,
        path + ": the map, which is asked for"), PACE, workers::start, () -> QueriedMap.open(shared, find(path)));
  }

  private NamedService find(String path) throws IOException {
    return services.find(path)
        .orElseThrow(() -> new IOException("the naming service has no " + path + " any more; start it again"));
  }

  /** The service of a component by which it takes parameters. */
  private Optional<String> parameters(String component) {
    return services.of(SmartPattern.QUERY, ParameterMaster.REQUEST).entrySet().stream()
        .filter(e -> e.getValue().name().component().equals(component)).map(Map.Entry::getKey).findFirst();
  }

  private void planner(String component, String path) {
    if (planners.containsKey(component)) {
      return;
    }
    PlannerGoals goals = new PlannerGoals(shared, () -> find(path));
    String port = component + "/goal";
    PlaceCommands<NavigationGoal> places =
        new PlaceCommands<>(component, shared.frames().map(), workers::start, goals, goals::failed);
    planners.put(component, places);
    offers.put(port, shared.context().offers().command(
        new CommandPort<>(port, NavigationGoal.class, Arity.MANY, "where the robot shall go, on the map, by " + path),
        goals.before(places)));
  }

  /** Deletes goals that we sent. */
  public synchronized void halt() {
    planners.values().forEach(PlaceCommands::halt);
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      planners.values().forEach(PlaceCommands::close);
      List.copyOf(offers.values()).forEach(Offer::close);
      maps.values().forEach(AskedStream::close);
    }
    workers.join(System.nanoTime() + END.toNanos());
  }
}
