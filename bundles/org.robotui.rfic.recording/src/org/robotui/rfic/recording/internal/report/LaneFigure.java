package org.robotui.rfic.recording.internal.report;

import java.util.Collection;
import java.util.List;
import org.robotui.api.replay.TimeRange;

/** When messages of each topic came, a lane for each; where one is missing for long is marked. */
final class LaneFigure {
  private static final int WIDTH = 960;
  private static final int NAMES = 240;
  private static final int LANE = 16;
  private static final int LETTERS = 36;

  private final TimeBins bins;
  private final TimeAxis axis;

  LaneFigure(TimeBins bins, long origin) {
    this.bins = bins;
    this.axis = new TimeAxis(bins.range(), origin, NAMES, WIDTH - NAMES - 20.0);
  }

  void draw(PageText page, Collection<TopicTally> topics) {
    List<TopicTally> shown = topics.stream().filter(each -> each.count() > 0).toList();
    int height = shown.size() * LANE;
    page.format("<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"Messages of each topic over time\">", WIDTH,
        height + 24);
    axis.draw(page, 0, height);
    for (int i = 0; i < shown.size(); i++) {
      lane(page, shown.get(i), i * LANE);
    }
    page.markup("</svg>");
  }

  private void lane(PageText page, TopicTally topic, int top) {
    page.format("<text class=\"name\" x=\"%d\" y=\"%d\">", NAMES - 8, top + LANE - 4).text(brief(topic.port()))
        .markup("</text>");
    int begin = -1;
    for (int bin = 0; bin <= bins.count(); bin++) {
      boolean some = bin < bins.count() && topic.density(bin) > 0;
      if (some && begin < 0) {
        begin = bin;
      } else if (!some && begin >= 0) {
        bar(page, "lane", x(begin), x(bin), top);
        begin = -1;
      }
    }
    if (topic.hasGap()) {
      TimeRange gap = topic.longestGap();
      bar(page, "gap", axis.x(gap.start()), axis.x(gap.end()), top);
    }
  }

  private double x(int bin) {
    return axis.left() + axis.width() * bin / bins.count();
  }

  private static void bar(PageText page, String kind, double from, double to, int top) {
    page.format("<rect class=\"%s\" x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\"/>", kind, from, top + 4,
        Math.max(1.2, to - from), LANE - 8);
  }

  /** The end of a long name says more than its beginning. */
  private static String brief(String name) {
    return name.length() <= LETTERS ? name : "\u2026" + name.substring(name.length() - LETTERS + 1);
  }
}
