package org.robotui.rfic.recording.internal;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.Descriptor;
import org.robotui.api.FileKind;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.session.SessionRfic;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.recording.internal.session.RecordingSession;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** The type {@code recording}: plays recordings as if they were robots. */
@Component(service = RficType.class)
public final class RecordingRficType implements RficType {
  private static final Duration RETRY = Duration.ofSeconds(3);
  /** Streams are those that were recorded; only browsing is always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("recording", "Recording",
      "Plays what was recorded of a robot, MCAP, a bag of ROS 1 or 2, a log of LCM, CARMEN or Player, as if it were the robot.",
      RecordingSettings.SCHEMA, List.of(TopicPorts.GRAPH));

  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline moves all recordings
   */
  @Activate
  public RecordingRficType(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Optional<FileKind> files() {
    return Optional.of(new FileKind("Recordings",
        List.of("mcap", "bag", "bag.active", "db3", "mcap.zstd", "db3.zstd", "lcm", "lcmlog", "log", "log.gz"),
        List.of("metadata.yaml", "*_0.db3", "*_0.mcap"), RecordingSettings.FILE));
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    return RecordingSettings.faults(settings);
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    RecordingSettings read = RecordingSettings.of(settings);
    return new SessionRfic(context, read.file().getFileName().toString(), RETRY,
        scope -> RecordingSession.open(context, read, timeline, scope));
  }
}
