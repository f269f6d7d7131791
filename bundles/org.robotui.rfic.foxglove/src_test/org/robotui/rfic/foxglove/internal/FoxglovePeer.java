package org.robotui.rfic.foxglove.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.rfic.GatedPeer;
import org.robotui.testkit.rfic.Sample;

/** A base behind a server, which is behind a gate(). What it says and in which encodings is another matter. */
final class FoxglovePeer extends GatedPeer {
  private static final VelocityCommand MOTION =
      new VelocityCommand(new Vector3(0.3, 0.1, 0.2), new Vector3(0.4, 0.5, -0.2));

  private final Dialect dialect;
  private Optional<FoxgloveServer> server = Optional.empty();

  FoxglovePeer(Dialect dialect) {
    this.dialect = dialect;
  }

  @Override
  public Rfic create(RficContext context) {
    return FoxgloveCase.rfic(context, Map.of("url", "ws://127.0.0.1:" + port(), "velocity", List.of("cmd_vel")));
  }

  @Override
  public void start() throws IOException {
    FoxgloveServer opened = new FoxgloveServer(dialect.capabilities(), dialect.encodings());
    dialect.offer(opened);
    server = Optional.of(opened);
    gate().open(opened.port());
  }

  @Override
  public void kill() {
    gate().shut();
    take();
    server.ifPresent(FoxgloveServer::close);
    server = Optional.empty();
  }

  @Override
  public void garble() {
    FoxgloveServer there = server.orElseThrow();
    there.tell(new byte[]{1, 2, 3});
    there.tell(Map.of("op", "advertise", "channels", List.of(Map.of())));
    for (int channel = 0; channel < samples().size(); channel++) {
      there.publish(channel, ByteBuffer.wrap(new byte[]{0, 1, 0, 0, 7}));
    }
  }

  @Override
  public List<Sample> samples() {
    return dialect.samples();
  }

  @Override
  public void say(Sample sample) {
    int channel = samples().indexOf(sample);
    server.ifPresent(there -> there.publish(channel, dialect.message(channel)));
  }

  @Override
  public int listeners(Sample sample) {
    return server.map(there -> there.listeners(samples().indexOf(sample))).orElse(0);
  }

  @Override
  public String motionPort() {
    return "cmd_vel";
  }

  @Override
  public Motion<?> motion() {
    return MOTION;
  }

  @Override
  public List<Data> heard() {
    take();
    return super.heard();
  }

  /** What this server heard since it was asked. */
  private void take() {
    server.ifPresent(there -> {
      for (FoxgloveServer.Said each = there.said.poll(); each != null; each = there.said.poll()) {
        hears(dialect.heard(each));
      }
    });
  }

  @Override
  public Set<String> registrations() {
    FoxgloveServer there = server.orElseThrow();
    Set<String> all = there.advertised.values().stream().map(each -> "publishes " + each.get("topic"))
        .collect(Collectors.toCollection(TreeSet::new));
    there.subscriptions.forEach(each -> all.add("subscribes " + each.channel()));
    return all;
  }
}
