package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.port.CommandSink;
import org.robotui.api.session.PlaceCommands;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.rfic.smartsoft.internal.convert.SmartPlaces;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.client.ParameterMaster.Response;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.naming.NamedService;

/** Tells a planner goals by its parameters: a circle on the map, in whole millimetres, without an angle. */
final class PlannerGoals implements PlaceCommands.Telling<NavigationGoal> {
  private static final String SET = "CommNavigationObjects.PlannerParams.";
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  /** What the planner of SmartSoft's own examples is told, in millimetres. */
  private static final String RADIUS = "100";

  private final SmartShared shared;
  private final Finding service;
  private final AtomicReference<Optional<String>> fault = new AtomicReference<>(Optional.empty());

  /** Finds where the parameters are taken. */
  interface Finding {
    NamedService find() throws IOException;
  }

  PlannerGoals(SmartShared shared, Finding service) {
    this.shared = shared;
    this.service = service;
  }

  @Override
  public void tell(NavigationGoal goal) throws IOException {
    send("SETDESTINATIONCIRCLE", List.of(millimetres(goal.pose().translation().x()),
        millimetres(goal.pose().translation().y()), RADIUS));
  }

  private static String millimetres(double metres) {
    return Long.toString(Math.round(metres * SmartPlaces.PER_METRE));
  }

  @Override
  public void halt() throws IOException {
    send("DELETEGOAL", List.of());
  }

  private void send(String name, List<String> values) throws IOException {
    try (QueryClient client = QueryClient.connect(service.find().address(), shared.links())) {
      Response response = new ParameterMaster(client, shared.types(), PATIENCE).send(SET + name, values);
      if (response != Response.OK) {
        throw new IOException(response == Response.BUSY ? "it has no time for " + name
            : "it does not know " + name + ", or not with " + values);
      }
    }
  }

  /** What the planner did not take is told to whoever sends the next goal, as nothing else tells it. */
  void failed(String reason) {
    fault.set(Optional.of(reason));
  }

  /** Says once why the goal before was not taken. */
  CommandSink<NavigationGoal> before(PlaceCommands<NavigationGoal> places) {
    return goal -> fault.getAndSet(Optional.empty()).<CommandSink.Sent>map(CommandSink.Sent.Refused::new)
        .orElseGet(() -> places.send(goal));
  }
}
