package org.robotui.rfic.recording.internal.report;

import java.io.IOException;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.Data;
import org.robotui.data.geometry.Pose;
import org.robotui.data.geometry.Twist;
import org.robotui.data.image.Image;
import org.robotui.data.sensor.Battery;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** What a recording tells of a session, found by reading it once; memory does not grow with its length. */
final class SessionFacts {
  private static final int COLUMNS = 600;
  private static final double PERCENT = 100;

  private final TimeBins bins;
  private final Map<String, TopicTally> topics = new LinkedHashMap<>();
  private final Map<String, BinnedSeries> series = new LinkedHashMap<>();
  private final Map<String, DrivenPath> paths = new LinkedHashMap<>();
  private final Map<String, CameraPictures> cameras = new LinkedHashMap<>();
  private final Happenings happenings = new Happenings();

  private SessionFacts(SearchableHistory history, TimeRange range) {
    bins = new TimeBins(range, COLUMNS);
    history.candidates().stream().sorted(Comparator.comparing(each -> each.id().port()))
        .forEach(each -> topics.put(each.id().port(), new TopicTally(each.id().port(), each.typeName(), bins)));
  }

  /** Reads a part of a recording. */
  static SessionFacts read(SearchableHistory history, TimeRange range) throws IOException, InterruptedException {
    SessionFacts facts = new SessionFacts(history, range);
    history.read(facts.topics.keySet(), range, new HistoryTaker() {
      @Override
      public void take(RecordedValue value) {
        facts.take(value);
      }

      @Override
      public void unreadable(String port, String reason) {
        facts.topics.get(port).unreadable(reason);
      }
    });
    return facts;
  }

  private void take(RecordedValue recorded) {
    String port = recorded.port();
    long time = recorded.time();
    Data value = recorded.value();
    topics.get(port).take(time);
    happenings.take(port, time, value);
    if (value instanceof Pose pose) {
      path(port, pose).take(pose.pose().translation());
    }
    if (value instanceof Twist twist) {
      series(port, "speed", "m/s").take(time, twist.linear().norm());
      series(port, "turning", "rad/s").take(time, twist.angular().z());
    }
    if (value instanceof Battery battery) {
      series(port, "charge", "%").take(time, battery.charge() * PERCENT);
      series(port, "voltage", "V").take(time, battery.voltage());
    }
    if (value instanceof Image image) {
      cameras.computeIfAbsent(port, name -> new CameraPictures(name, bins.range())).take(time, image);
    }
  }

  private DrivenPath path(String port, Pose pose) {
    return paths.computeIfAbsent(port, name -> new DrivenPath(name, pose.frame().name(), pose.pose().translation()));
  }

  private BinnedSeries series(String port, String what, String unit) {
    return series.computeIfAbsent(port + " " + what, name -> new BinnedSeries(name, unit, bins));
  }

  TimeBins bins() {
    return bins;
  }

  Collection<TopicTally> topics() {
    return topics.values();
  }

  /** Those that have a number at least. */
  List<BinnedSeries> series() {
    return series.values().stream().filter(each -> !each.isEmpty()).toList();
  }

  /** By frames: what is in one frame can be drawn together. */
  Map<String, List<DrivenPath>> paths() {
    return paths.values().stream()
        .collect(Collectors.groupingBy(DrivenPath::frame, LinkedHashMap::new, Collectors.toList()));
  }

  Collection<CameraPictures> cameras() {
    return cameras.values();
  }

  Happenings happenings() {
    return happenings;
  }
}
