package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.data.control.Drives;
import org.robotui.data.joint.RobotDescription;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.xbot.internal.follow.FollowActions;
import org.robotui.rfic.xbot.internal.task.TaskHandles;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.Urdf;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.RtClient;
import org.robotui.xbot.StateFrame;

/**
 * One attachment, from the connection to the end of the supervisor: offers what the control has, and reads it at a
 * rate.
 */
final class XbotSession implements RobotSession {
  private static final Duration SLOW = Duration.ofMillis(200);
  private static final Duration ASK = Duration.ofSeconds(2);
  private static final Duration SILENT = Duration.ofMillis(500);

  private final RficContext context;
  private final XbotSettings settings;
  private final RtClient client;
  private final Streams streams;
  private final XbotCommands commands;
  private final CycleFeed cycles;
  private final Optional<TaskHandles> handles;
  private final List<Offer> offers = new ArrayList<>();
  private final LinkChanges link;
  private StateFrame.Hardware hardware = StateFrame.Hardware.OK;
  private long newest;
  private long newestSince = System.nanoTime();
  private long slowAt;
  private String damage = "";
  private Drives drives = new Drives(List.of());
  private EmergencyStops stops = new EmergencyStops(List.of());

  XbotSession(RficContext context, XbotSettings settings, RtClient client) throws IOException {
    this.context = context;
    this.settings = settings;
    this.client = client;
    this.link = new LinkChanges(context.link());
    Board board = board();
    Optional<RobotDescription> description = description();
    this.streams = new Streams(context, board,
        new ModelFrames(context.robot(), description.map(RobotDescription::urdf).orElse("")));
    description.ifPresent(streams::describe);
    this.commands = new XbotCommands(client, context.threads());
    this.cycles = new CycleFeed(context, client);
    Verbs verbs = new Verbs(client);
    offers.add(context.offers().command(XbotPorts.COMMAND, commands));
    offers.add(context.offers().call(XbotPorts.VERBS, verbs));
    offers.add(context.offers().call(XbotPorts.SERVICES, new StopService(verbs, client::board)));
    FollowActions actions = new FollowActions(new SupervisorLink(client, ASK));
    offers.add(context.offers().call(TopicPorts.ACTIONS, actions));
    handles = description.flatMap(known -> Urdf.parse(known.urdf()).found()).map(this::handles);
    offers.add(context.offers().browse(TopicPorts.GRAPH, new XbotBrowser(actions)));
  }

  private TaskHandles handles(RobotModel model) {
    TaskHandles made = new TaskHandles(context.robot(), model, new SupervisorLink(client, ASK), streams.handleSite(),
        context.threads());
    offers.add(context.offers().command(TopicPorts.MARKER_FEEDBACK, made));
    return made;
  }

  /** Asked once, as it does not change while a control runs. */
  private Optional<RobotDescription> description() throws IOException {
    return new DescriptionReader(words -> client.request(words, ASK))
        .read(context.robot(), Optional.ofNullable(System.getenv("ROS_PACKAGE_PATH")).orElse(""));
  }

  private Board board() throws IOException {
    return client.board()
        .orElseThrow(() -> new IOException("the control of " + settings.robot() + " says nothing that can be read"));
  }

  /** Reads until the supervisor has gone, and says why it ended. */
  @Override
  public Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException {
    while (!over.getAsBoolean()) {
      if (!client.refresh()) {
        return Optional.of("the real-time control of " + settings.robot() + " has ended");
      }
      read(System.nanoTime());
      Thread.sleep(settings.period());
    }
    return Optional.empty();
  }

  private void read(long now) throws IOException {
    Board board = board();
    long cycle = client.newestCycle();
    if (cycle != newest) {
      newest = cycle;
      newestSince = now;
      client.state().ifPresent(state -> publish(board, state));
    }
    if (now - slowAt > SLOW.toNanos()) {
      slowAt = now;
      List<HostReading> hosts = client.hosts();
      damage = Convert.damage(board, hosts);
      streams.publishSlow(board, client.loop(), hosts);
      readDrives();
      readStops();
    }
    link.report(state(board, now));
  }

  /** A question to the supervisor: asked where somebody wants to know, or hardware that does not answer may be off. */
  private void readDrives() throws IOException {
    if (streams.wantsDrives() || hardware == StateFrame.Hardware.TIMEOUT) {
      Answer answer = client.request("drives", ASK);
      drives = answer.ok() ? DriveReader.read(answer.text()) : new Drives(List.of());
      streams.publish(drives);
    }
  }

  /** Likewise. */
  private void readStops() throws IOException {
    if (streams.wantsStops() || hardware == StateFrame.Hardware.EMERGENCY_STOP) {
      Answer answer = client.request("stops", ASK);
      stops = EmergencyStops.read(answer.ok() ? answer.text() : "");
      streams.publish(stops.diagnostics());
    }
  }

  private void publish(Board board, StateFrame state) {
    hardware = state.hardware();
    streams.publish(board, state);
  }

  private LinkState state(Board board, long now) {
    String peer = board.robot() + " (" + board.hal() + ")";
    if (now - newestSince > SILENT.toNanos()) {
      return new LinkState.Degraded(peer,
          "no cycle for " + SILENT.toMillis() + " ms: the process at the hardware stands still or is gone");
    }
    return switch (hardware) {
      case TIMEOUT -> new LinkState.Degraded(peer,
          DriveReader.off(drives).orElse("the hardware does not answer in time"));
      case FAULT -> new LinkState.Degraded(peer, "the hardware reports a fault");
      case EMERGENCY_STOP -> new LinkState.Degraded(peer,
          stops.reason().orElse("an emergency stop is pressed: all joints are safe"));
      case OK -> damage.isEmpty() ? new LinkState.Connected(peer) : new LinkState.Degraded(peer, damage);
    };
  }

  @Override
  public void close() {
    offers.forEach(Offer::close);
    commands.close();
    handles.ifPresent(TaskHandles::close);
    cycles.close();
    streams.close();
  }
}
