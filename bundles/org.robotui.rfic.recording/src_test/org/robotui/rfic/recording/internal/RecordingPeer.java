package org.robotui.rfic.recording.internal;

import static org.robotui.rfic.recording.internal.SmallRecording.time;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.config.Placed;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.TrackId;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.Motion;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.recording.internal.time.SharedTimeline;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A file in place of a robot. It says something where the timeline is taken to its next message. */
final class RecordingPeer implements Peer {
  private static final int MESSAGES = 300;
  private static final String TOPIC = "/odom";
  private static final Sample ODOMETRY = new Sample("odom",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          new RigidTransform(new Vector3(7, 0, 0), Quaternion.IDENTITY), Doubles.wrap(new double[36]), Vector3.ZERO,
          Vector3.ZERO, Doubles.wrap(new double[36])),
      Optional.of(new Stamp(time(0), ClockKind.SIMULATED)));

  private final SharedTimeline timeline = new SharedTimeline();
  private final Path folder;

  RecordingPeer() {
    try {
      folder = Files.createTempDirectory("recording");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Path file() {
    return folder.resolve("run.mcap");
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of(Capability.COMMANDS, "nobody commands a recording", Capability.DEMAND, "a file is not asked",
        Capability.REGISTRATIONS, "a file keeps no list", Capability.RETURN, "a file that is open stays",
        Capability.HANG, "a file does not hang", Capability.GARBAGE,
        "what is damaged in a file is there from the beginning");
  }

  @Override
  public Rfic create(RficContext context) {
    RecordingRficType type = new RecordingRficType(timeline);
    FakeSettings settings = new FakeSettings(type.schema());
    settings.set("file", Placed.nowhere(file().toString()));
    settings.set("play", false);
    return type.create(context, settings.current());
  }

  @Override
  public void start() throws IOException {
    Path next = folder.resolve("next");
    try (SmallRecording recording = new SmallRecording(next)) {
      recording.odometry(TOPIC, 0, 7);
      for (int i = 1; i < MESSAGES; i++) {
        recording.again(TOPIC, i);
      }
    }
    Files.move(next, file());
  }

  @Override
  public void kill() throws IOException {
    Files.delete(file());
  }

  @Override
  public void hang() {
    throw new UnsupportedOperationException();
  }

  @Override
  public void goOn() {
    throw new UnsupportedOperationException();
  }

  @Override
  public void garble() {
    throw new UnsupportedOperationException();
  }

  @Override
  public List<Sample> samples() {
    return List.of(ODOMETRY);
  }

  @Override
  public void say(Sample sample) {
    TimelineState before = timeline.state();
    boolean atEnd = before.span().filter(span -> span.end() == before.position()).isPresent();
    if (atEnd) {
      timeline.seek(time(0));
    } else {
      timeline.step(true, Optional.of(new LaneId(new TrackId("robby", "base"), TOPIC)));
    }
  }

  @Override
  public int listeners(Sample sample) {
    throw new UnsupportedOperationException();
  }

  @Override
  public String motionPort() {
    throw new UnsupportedOperationException();
  }

  @Override
  public Motion<?> motion() {
    throw new UnsupportedOperationException();
  }

  @Override
  public List<Data> heard() {
    throw new UnsupportedOperationException();
  }

  @Override
  public Set<String> registrations() {
    throw new UnsupportedOperationException();
  }

  /** Who has the file open. */
  @Override
  public int links() {
    try (Stream<Path> all = Files.list(Path.of("/proc/self/fd"))) {
      return (int) all.filter(each -> leadsTo(each, file())).count();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean leadsTo(Path descriptor, Path file) {
    try {
      return Files.readSymbolicLink(descriptor).equals(file);
    } catch (IOException e) {
      return false; // closed meanwhile
    }
  }

  @Override
  public void close() {
    try {
      Files.deleteIfExists(file());
      Files.deleteIfExists(folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
