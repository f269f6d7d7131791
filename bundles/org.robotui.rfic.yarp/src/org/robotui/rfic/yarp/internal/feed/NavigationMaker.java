package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Offer;
import org.robotui.api.port.StreamPort;
import org.robotui.api.session.AskedStream;
import org.robotui.api.session.PlaceCommands;
import org.robotui.data.Data;
import org.robotui.data.geometry.Pose;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.NavigationForms;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortCall;

/** Makes streams and commands of servers of navigation, localisation and maps, which are asked. */
final class NavigationMaker implements AutoCloseable {
  private static final Duration OFTEN = Duration.ofMillis(500);
  private static final Duration SELDOM = Duration.ofSeconds(10);
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final String POSITION = "get_current_position1_RPC";

  private final Wires wires;
  private final YarpDevices devices;
  private final Function<Bottle, PoseEstimate> located;
  private final List<Offer> commands = new CopyOnWriteArrayList<>();
  private final List<AskedStream<?>> feeds = new CopyOnWriteArrayList<>();
  private final List<PlaceCommands<?>> senders = new CopyOnWriteArrayList<>();
  private final AtomicReference<Optional<String>> map = new AtomicReference<>(Optional.empty());

  /** What is said of a place is made into a pose by what is given. */
  NavigationMaker(Wires wires, YarpDevices devices, Function<Bottle, PoseEstimate> located) {
    this.wires = wires;
    this.devices = devices;
    this.located = located;
  }

  /** Hears on which map the robot is. */
  void at(Bottle place) {
    map.set(Optional.of(place.get(0).text()).filter(name -> !name.isEmpty()));
  }

  void navigation(String name, String port) {
    AtomicReference<NavigationStatus.State> last = new AtomicReference<>(NavigationStatus.State.SUCCEEDED);
    AskedStream<NavigationStatus> status = asked(name, port + "/status", NavigationStatus.class,
        "how far the goal is", OFTEN, asking -> changed(answered(asking, "get_navigation_status_RPC"), last));
    PlaceCommands<NavigationGoal> sender = places(name,
        new PlaceSender<>(wires, where(name), "goto_target_by_absolute_location_RPC",
            Optional.of("stop_navigation_RPC"),
            this::current),
        reason -> status.publish(new NavigationStatus("", NavigationStatus.State.REJECTED, reason)));
    commands.add(wires.context().offers().command(new CommandPort<>(port + "/goal", NavigationGoal.class, Arity.MANY,
        name + ": where the robot shall go, on the map"), sender));
  }

  private <C extends Pose> PlaceCommands<C> places(String name, PlaceSender<C> sender, Consumer<String> refused) {
    PlaceCommands<C> places = new PlaceCommands<>(name, wires.frames().map(), wires.workers()::start, sender, refused);
    senders.add(places);
    return places;
  }

  /** Idle after it was on its way means that somebody has stopped it. */
  private static Optional<NavigationStatus> changed(Bottle answer, AtomicReference<NavigationStatus.State> last) {
    Optional<NavigationStatus.State> state = NavigationForms.state(answer);
    NavigationStatus.State before = last.get();
    NavigationStatus.State now = state.orElse(before == NavigationStatus.State.ACTIVE
        ? NavigationStatus.State.CANCELED
        : before);
    last.set(now);
    return state.isPresent() || now != before ? Optional.of(new NavigationStatus("", now, "")) : Optional.empty();
  }

  void localization(String name, String port) {
    AskedStream<PoseEstimate> position =
        asked(name, port + "/position", PoseEstimate.class, "where it is on the map", OFTEN, asking -> {
          Bottle place = answered(asking, POSITION).get(1).items();
          at(place);
          return Optional.of(located.apply(place));
        });
    PlaceCommands<PoseEstimate> sender = places(name,
        new PlaceSender<>(wires, where(name), "set_initial_pose1_RPC", Optional.empty(), this::current),
        position::failed);
    commands.add(wires.context().offers().command(new CommandPort<>(port + "/initial_pose", PoseEstimate.class,
        Arity.MANY, name + ": where the robot is, on the map"), sender));
  }

  void maps(String name, String port) {
    asked(name, port + "/map", GridMap.class, "the map on which the robot is, else the first one", SELDOM, this::fetch);
  }

  private <D extends Data> AskedStream<D> asked(String name, String port, Class<D> type, String help, Duration pace,
      AskedFeed.Making<D> making) {
    AskedStream<D> stream = new AskedStream<>(wires.context(),
        new StreamPort<>(port, type, Arity.MANY, name + ": " + help), pace, wires.workers()::start,
        () -> new AskedFeed<>(wires, PortCall.connect(where(name).get(), wires.own() + "/rpc", wires.options()),
            making));
    feeds.add(stream);
    return stream;
  }

  private Optional<GridMap> fetch(AskedFeed.Questions asking) throws IOException {
    List<String> names = answered(asking, "get_map_names_RPC").get(1).items().values().stream()
        .map(each -> each.text()).toList();
    String name = current().filter(names::contains).or(() -> names.stream().findFirst())
        .orElseThrow(() -> new IOException("it has no maps"));
    Bottle answer = asking.ask(NavigationForms.question("get_map_RPC", new YarpValue.Text(name)));
    return Optional.of(NavigationForms.map(done(answer).get(1).items(), wires.frames().map()));
  }

  private static Bottle answered(AskedFeed.Questions asking, String function) throws IOException {
    return done(asking.ask(NavigationForms.question(function)));
  }

  private static Bottle done(Bottle answer) throws IOException {
    if (!NavigationForms.isDone(answer)) {
      throw new IOException("it answered " + answer);
    }
    return answer;
  }

  /** Where nobody looks at localisation, it is asked for the map. */
  private Optional<String> current() {
    if (map.get().isEmpty()) {
      devices.kinds().entrySet().stream().filter(e -> e.getValue() == YarpDevice.LOCALIZATION).map(Map.Entry::getKey)
          .findFirst().ifPresent(this::askPlace);
    }
    return map.get();
  }

  private void askPlace(String name) {
    try (PortCall call = PortCall.connect(where(name).get(), wires.own() + "/rpc", wires.options())) {
      call.ask(NavigationForms.question(POSITION), PATIENCE).toOptional().filter(NavigationForms::isDone)
          .ifPresent(answer -> at(answer.get(1).items()));
    } catch (IOException e) {
      // then nothing tells, which whoever sets a goal is told
    }
  }

  private Supplier<HostPort> where(String name) {
    return () -> devices.address(name).orElseThrow();
  }

  /** Stops what we sent on its way. */
  void halt() {
    senders.forEach(PlaceCommands::halt);
  }

  @Override
  public void close() {
    senders.forEach(PlaceCommands::close);
    commands.forEach(Offer::close);
    feeds.forEach(AskedStream::close);
  }
}
