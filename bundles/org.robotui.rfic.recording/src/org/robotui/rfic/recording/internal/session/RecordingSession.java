package org.robotui.rfic.recording.internal.session;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionScope;
import org.robotui.data.ClockKind;
import org.robotui.message.data.FrameNames;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.SharedTransforms;
import org.robotui.message.topic.TopicPorts;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.RecordingSettings;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.Seat;
import org.robotui.rfic.recording.internal.time.SharedTimeline;
import org.robotui.web.LinkTurns;

/** An open recording as a robot. */
public final class RecordingSession implements RobotSession {
  private static final long END_NANOS = TimeUnit.SECONDS.toNanos(1);

  private final RecordingReader recording;
  private final LinkChanges link;
  private final String words;
  private final TrackPlayer player;
  private final RecordedHistory history;
  private final RobotTopics topics;
  private final DescriptionTopics description;
  private final Offer browsing;
  private final Seat seat;
  private final List<Thread> threads;
  private volatile boolean over;

  private RecordingSession(RficContext core, RecordingSettings settings, RecordingReader recording, TimeRange span,
      SharedTimeline timeline) {
    this.recording = recording;
    this.link = new LinkChanges(core.link());
    RosDefinitions definitions = new RosDefinitions(System.getenv());
    TopicTable table = new TopicTable(recording, new PayloadFormats(definitions));
    this.words = RecordingWords.of(settings.file(), span, table.topics().size());
    LaneScan lanes = new LaneScan(table, recording, span);
    PlayedContext context = new PlayedContext(core);
    this.player = new TrackPlayer(context, recording, span, lanes::lanes, this::history);
    String name = settings.file().getFileName().toString();
    this.history = new RecordedHistory(recording, table, name, span, timeline, player::offset);
    RecordedTopics channels = new RecordedTopics(table, definitions, name, player::now, player::look,
        settings.topics(), history);
    history.addAll(new FrameNames(core.robot(), ClockKind.SIMULATED), core.instance(), settings.topics());
    this.topics = new RobotTopics(context, settings.topics(), channels, new SharedTransforms(table::isNamespace));
    this.description = new DescriptionTopics(context, settings.topics(),
        DescriptionTopics.packages(System.getenv()), channels);
    this.browsing = core.offers().browse(TopicPorts.GRAPH, new RecordingBrowser(table, span.length() / 1e9));
    topics.follow(description.follow(table.graph()));
    this.seat = timeline.add(player, settings.playing(), core.stateFolder());
    Thread scan = core.threads().newThread(() -> scan(lanes));
    scan.start();
    this.threads = List.of(player.start(channels::wanted, seat), scan);
  }

  private SearchableHistory history() {
    return history;
  }

  private static String empty(RecordingReader recording) {
    return recording.file() + " has no message that can be read, so that there is nothing to play"
        + recording.damages().stream().findFirst().map(damage -> ": " + damage).orElse("");
  }

  private void scan(LaneScan lanes) {
    try {
      lanes.run(() -> over);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Opens a recording; one without an index is read through.
   *
   * @param context what core gives
   * @param settings which
   * @param timeline moves it
   * @param scope keeps the file open until the session has been closed
   * @return the session
   * @throws IOException where it cannot be read
   */
  public static RobotSession open(RficContext context, RecordingSettings settings, SharedTimeline timeline,
      SessionScope scope) throws IOException {
    RecordingReader recording =
        scope.closing(RecordingFiles.open(settings.file(), settings.types(), progress(context, settings)),
            RecordingReader::close);
    TimeRange span = recording.span().filter(each -> each.end() >= 0 && each.start() <= Seat.FARTHEST)
        .map(each -> new TimeRange(Math.max(0, each.start()), Math.min(Seat.FARTHEST, each.end())))
        .orElseThrow(() -> new IOException(empty(recording)));
    return new RecordingSession(context, settings, recording, span, timeline);
  }

  private static ScanProgress progress(RficContext context, RecordingSettings settings) {
    LinkChanges link = new LinkChanges(context.link());
    return (done, size) -> link.report(new LinkState.Connecting(settings.file().getFileName() + ", which has no index, "
        + (size == 0 ? 0 : done * 10 / size * 10) + " % read"));
  }

  @Override
  public Optional<String> follow(BooleanSupplier closed) throws InterruptedException {
    return LinkTurns.take(player.ended(), closed, this::turn);
  }

  private Optional<String> turn() {
    topics.tick();
    description.tick();
    link.report(state());
    return Optional.empty();
  }

  private LinkState state() {
    List<RecordingDamage> damages = recording.damages();
    if (damages.isEmpty() && topics.problem().isEmpty()) {
      return new LinkState.Connected(words);
    }
    String rest = damages.size() > 1 ? " (and " + (damages.size() - 1) + " more; ./robotui log check names them)" : "";
    return new LinkState.Degraded(words,
        damages.isEmpty() ? topics.problem() : "the file is damaged: " + damages.getFirst() + rest);
  }

  @Override
  public void close() {
    over = true;
    seat.close();
    long deadline = System.nanoTime() + END_NANOS;
    threads.forEach(each -> RficWorker.join(each, deadline));
    browsing.close();
    description.close();
    topics.close();
  }
}
