package org.robotui.uic.topics.internal.view;

import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ask.Measure;
import org.robotui.ui.control.Column;
import org.robotui.uic.topics.internal.model.TopicRow;

/** The columns of the list. Display thread, but for the orders, which are pure. */
final class TopicColumns {
  /** Where a click switches measuring. */
  static final int TICK_WIDTH = 32;

  private static final int BOX = 13;
  private static final int CORNER = 4;

  private TopicColumns() {}

  static List<Column<TopicRow>> topics(Theme theme) {
    return List.of(
        Column.<TopicRow>words("", row -> row.measured() ? "measured" : "").width(TICK_WIDTH).unsearched()
            .painted((gc, at, row) -> box(gc, theme, at, row))
            .hint(row -> row.entry().stream().isPresent() ? "Measure its rate (M)" : ""),
        name("Topic"),
        type().from(360),
        count("Pub", row -> row.counts().publishers().orElse(-1),
            "Number of publishers; known once the topic was selected")
            .from(620),
        count("Sub", row -> row.counts().subscribers().orElse(-1),
            "Number of subscribers; known once the topic was selected")
            .from(620),
        figure("Rate", 76, TopicText::rate, Measure::hertz).role(TopicColumns::role),
        figure("Jitter", 74, m -> TopicText.period(m.jitter()), Measure::jitter).from(760),
        figure("Shortest", 78, m -> TopicText.period(m.shortest()), Measure::shortest).from(980),
        figure("Longest", 78, m -> TopicText.period(m.longest()), Measure::longest).from(980),
        figure("Bandwidth", 92, m -> TopicText.bandwidth(m.bytesPerSecond()), m -> m.bytesPerSecond().orElse(-1))
            .from(520),
        figure("Messages", 84, m -> Long.toString(m.count()), Measure::count).from(860));
  }

  static List<Column<TopicRow>> nodes() {
    return List.of(name("Node"),
        count("Publishes", row -> row.counts().publishers().orElse(-1),
            "How many topics it publishes; known once the node was selected")
            .width(86).from(360),
        count("Subscribes", row -> row.counts().subscribers().orElse(-1),
            "How many topics it subscribes to; known once the node was selected")
            .width(86).from(360));
  }

  static List<Column<TopicRow>> others() {
    return List.of(name("Name"), type().from(320));
  }

  private static Column<TopicRow> name(String title) {
    return Column.words(title, TopicRow::label).weight(3).order(Comparator.comparing(TopicRow::label));
  }

  private static Column<TopicRow> type() {
    return Column.words("Type", TopicRow::type).brief(TopicColumns::withoutPackage).weight(2.4).role(Role.DIM)
        .order(Comparator.comparing(TopicRow::type));
  }

  private static String withoutPackage(String type) {
    return type.substring(type.lastIndexOf('/') + 1);
  }

  private static Column<TopicRow> count(String title, Function<TopicRow, Integer> value, String hint) {
    return Column.<TopicRow>figures(title, row -> value.apply(row) < 0 ? "" : Integer.toString(value.apply(row)))
        .width(48).role(Role.DIM).order(Comparator.comparing(value)).hint(row -> hint);
  }

  private static Column<TopicRow> figure(String title, int width, Function<Measure, String> text,
      ToDoubleFunction<Measure> value) {
    return Column.<TopicRow>figures(title, row -> row.measure().map(text).orElse("")).width(width).unsearched()
        .order(Comparator
            .comparingDouble(row -> row.measure().map(value::applyAsDouble).filter(v -> !v.isNaN()).orElse(-1.0)));
  }

  /** What is waited for, or has ended, stands back. */
  private static Role role(TopicRow row) {
    return row.measure().map(m -> m.count() == 0 ? Role.DIM : m.hertz() == 0 ? Role.WARNING : Role.TEXT)
        .orElse(Role.DIM);
  }

  /** What has no stream cannot be measured, and has no box. */
  private static void box(GC gc, Theme theme, Rectangle at, TopicRow row) {
    if (row.entry().stream().isPresent() || row.measured()) {
      box(gc, theme, at, row.measured());
    }
  }

  private static void box(GC gc, Theme theme, Rectangle at, boolean on) {
    int x = at.x + (at.width - BOX) / 2;
    int y = at.y + (at.height - BOX) / 2;
    gc.setLineWidth(1);
    gc.setForeground(theme.color(on ? Role.ACCENT : Role.LINE));
    if (on) {
      gc.setBackground(theme.color(Role.ACCENT));
      gc.fillRoundRectangle(x, y, BOX, BOX, CORNER, CORNER);
      gc.setForeground(theme.on(Role.ACCENT));
      Icons.paint(gc, Icon.CHECK, x + 1, y + 1, BOX - 2);
    } else {
      gc.setForeground(theme.mix(Role.DIM, Role.PANEL, 0.6));
      gc.drawRoundRectangle(x, y, BOX, BOX, CORNER, CORNER);
    }
  }
}
