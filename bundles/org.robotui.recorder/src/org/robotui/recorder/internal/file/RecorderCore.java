package org.robotui.recorder.internal.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.host.Host;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecorderState.Ended;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingOutcome.Done;
import org.robotui.api.record.RecordingOutcome.Refused;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingWriter;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One recording at a time, and the last seconds beside it. */
public final class RecorderCore implements Recorder, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RecorderCore.class);
  private static final Duration SHORTEST = Duration.ofSeconds(1);
  private static final Duration LONGEST = Duration.ofMinutes(10);
  private static final long MOST_RECENT = 256L << 20;
  private static final String RECORDING = "recording";
  private static final String RECENT = "recent";

  private final Host host;
  private final String version;
  private final Disk disk;
  private final FileSeries.Maker maker;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private volatile Optional<RunningRecording> running = Optional.empty();
  private volatile Optional<Ended> ended = Optional.empty();
  private volatile Optional<RecentMessages> recent = Optional.empty();

  /** Records nothing yet. */
  public RecorderCore(Host host, String version) {
    this(host, version, new Disk(), RecordingWriter::create);
  }

  RecorderCore(Host host, String version, Disk disk, FileSeries.Maker maker) {
    this.host = host;
    this.version = version;
    this.disk = disk;
    this.maker = maker;
  }

  @Override
  public Optional<String> obstacle(RecordingPlan plan) {
    return disk.obstacle(FileSeries.first(plan, Disk.file(plan.target(), RECORDING)));
  }

  @Override
  public synchronized RecordingOutcome start(RecordingPlan plan) {
    if (running.isPresent()) {
      return new Refused("it records already, to " + running.get().status().file() + "; stop that first");
    }
    Path base = Disk.file(plan.target(), RECORDING);
    Optional<String> obstacle = disk.obstacle(FileSeries.first(plan, base));
    if (obstacle.isPresent()) {
      return new Refused(obstacle.get());
    }
    try {
      RunningRecording begun = RunningRecording.begin(new RunningRecording.Needs(host, disk, maker, extras()), plan,
          base, this::tell, this::failed);
      running = Optional.of(begun);
      tell();
      List<Path> files = begun.status().files();
      return new Done(files, "recording to " + files.getLast());
    } catch (RecordingException e) {
      return new Refused(e.getMessage());
    }
  }

  private FileSeries.Extras extras() {
    Map<String, String> notes = new LinkedHashMap<>();
    notes.put("robotui", version);
    notes.put("java", Runtime.version().toString());
    notes.put("system", System.getProperty("os.name") + " " + System.getProperty("os.version"));
    notes.put("started", Instant.now().toString());
    notes.put("robot_uis", String.join(", ", host.ruics().stream().map(each -> each.name()).toList()));
    return new FileSeries.Extras(notes, host.configurationTexts());
  }

  /** On the thread that writes: whoever starts or stops may wait for it. */
  private void failed(String reason) {
    Thread.ofPlatform().daemon().name("robotui-recorder-end").start(() -> {
      synchronized (this) {
        running.filter(each -> !each.failure().isEmpty()).ifPresent(each -> finish(each));
      }
      tell();
    });
  }

  private RecordingStatus finish(RunningRecording each) {
    each.stop();
    RecordingStatus status = each.status();
    ended = Optional.of(new Ended(status, each.failure()));
    running = Optional.empty();
    return status;
  }

  @Override
  public synchronized RecordingOutcome stop() {
    if (running.isEmpty()) {
      return new Refused("nothing is recorded");
    }
    RunningRecording each = running.get();
    RecordingStatus status = finish(each);
    tell();
    return new Done(status.files(), each.failure().isEmpty()
        ? status.messages() + " messages, " + Disk.size(status.bytes()) + " in " + status.file()
        : each.failure());
  }

  @Override
  public synchronized RecordingOutcome keepRecent(Duration limit, RecordingChoice choice) {
    if (limit.compareTo(SHORTEST) < 0 || limit.compareTo(LONGEST) > 0) {
      return new Refused("the last seconds can be kept for 1 s to 10 minutes, not for " + limit.toSeconds() + " s");
    }
    forgetRecent();
    long most = Math.min(MOST_RECENT, Runtime.getRuntime().maxMemory() / 8);
    recent = Optional.of(new RecentMessages(host, limit, choice, most));
    tell();
    return new Done(List.of(), "the last " + limit.toSeconds() + " s are kept");
  }

  @Override
  public synchronized void forgetRecent() {
    Optional<RecentMessages> before = recent;
    recent = Optional.empty();
    before.ifPresent(RecentMessages::close);
    if (before.isPresent()) {
      tell();
    }
  }

  @Override
  public RecordingOutcome saveRecent(Path target) {
    Optional<RecentMessages> from = recent;
    if (from.isEmpty()) {
      return new Refused("the last seconds are not kept; switch that on first");
    }
    Path file = Disk.file(target, RECENT);
    Optional<String> obstacle = disk.obstacle(file);
    return obstacle.<RecordingOutcome>map(Refused::new).orElseGet(() -> save(from.get().all(), file));
  }

  private RecordingOutcome save(List<Captured> messages, Path file) {
    if (messages.isEmpty()) {
      return new Refused("nothing has come in the last seconds");
    }
    FileSeries series = new FileSeries(RecordingPlan.of(file), file, maker, extras());
    try {
      for (Captured each : messages) {
        series.write(each);
      }
      series.end();
      return new Done(List.of(file), messages.size() + " messages, " + Disk.size(series.bytes()) + " in " + file);
    } catch (RecordingException e) {
      discard(file);
      return new Refused(e.getMessage());
    }
  }

  /** Half of the last seconds would be taken for all of them. */
  private static void discard(Path file) {
    try {
      Files.deleteIfExists(file);
    } catch (IOException e) {
      LOG.info("{} is left, though it is not whole: {}", file, e.getMessage());
    }
  }

  @Override
  public RecorderState state() {
    return new RecorderState(running.map(RunningRecording::status), ended, recent.map(RecentMessages::state));
  }

  @Override
  public Subscription listen(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  private void tell() {
    listeners.forEach(Runnable::run);
  }

  @Override
  public void close() {
    forgetRecent();
    stop();
  }
}
