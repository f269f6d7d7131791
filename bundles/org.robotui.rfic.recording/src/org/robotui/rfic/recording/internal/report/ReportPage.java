package org.robotui.rfic.recording.internal.report;

import java.io.IOException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.status.Severity;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** A recorded session as one page of HTML, with its figures and pictures in it; it is well-formed XML, too. */
public final class ReportPage {
  private static final double SECOND = 1e9;

  private final ReportedFile file;
  private final long origin;
  private final SessionFacts facts;
  private final PageText page = new PageText();

  private ReportPage(ReportedFile file, long origin, SessionFacts facts) {
    this.file = file;
    this.origin = origin;
    this.facts = facts;
  }

  /**
   * Reads a part of a recording and writes what it tells.
   *
   * @param file which one it is
   * @param history all of it
   * @param range the part
   * @return the page
   * @throws IOException where the file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   */
  public static String of(ReportedFile file, SearchableHistory history, TimeRange range)
      throws IOException, InterruptedException {
    ReportPage report = new ReportPage(file, history.span().start(), SessionFacts.read(history, range));
    report.write();
    return report.page.toString();
  }

  private void write() {
    page.markup("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>")
        .markup("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>")
        .element("title", file.name())
        .markup("<style>").markup(ReportStyle.CSS).markup("</style></head><body><header>").element("h1", file.name())
        .element("p", subtitle()).markup("</header>");
    problems();
    happenings();
    paths();
    figures();
    pictures();
    messages();
    page.markup("<footer>Written by RobotUI. Times are seconds or minutes from the beginning of the recording.")
        .markup("</footer></body></html>\n");
  }

  private String subtitle() {
    TimeRange range = facts.bins().range();
    String part = range.start() == origin ? "" : ", from " + at(range.start());
    return instant(range.start()) + ", " + TimeAxis.length(range.length() / SECOND) + part + ", "
        + counted(facts.topics().stream().mapToLong(TopicTally::count).sum(), "message") + " of "
        + counted(facts.topics().stream().filter(each -> each.count() > 0).count(), "topic");
  }

  private static String counted(long count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  private static Instant instant(long nanos) {
    return Instant.EPOCH.plusNanos(nanos).truncatedTo(ChronoUnit.MILLIS);
  }

  private String at(long time) {
    return TimeAxis.words((time - origin) / SECOND);
  }

  private void problems() {
    List<String> all = new ArrayList<>(file.damages());
    facts.topics().forEach(each -> each.obstacle()
        .ifPresent(why -> all.add("messages of " + each.port() + " could not be read: " + why)));
    if (!all.isEmpty()) {
      page.markup("<section class=\"problems\"><h2>Damaged or not readable</h2><ul>");
      all.forEach(each -> page.element("li", each));
      page.markup("</ul></section>");
    }
  }

  private void happenings() {
    page.markup("<section><h2>What happened</h2>");
    List<Happening> all = facts.happenings().all();
    if (all.isEmpty()) {
      page.element("p", "No warning, no error, no goal and no event of RobotUI was recorded.");
    } else {
      page.markup("<table><thead><tr><th>Time</th><th></th><th>Who</th><th>What</th></tr></thead><tbody>");
      all.forEach(this::happening);
      page.markup("</tbody></table>");
    }
    if (facts.happenings().more() > 0) {
      page.element("p", facts.happenings().more() + " more are left out; log find lists what you look for.");
    }
    page.markup("</section>");
  }

  private void happening(Happening each) {
    page.markup("<tr class=\"" + each.severity().name().toLowerCase(Locale.ROOT) + "\">").element("td", at(each.time()))
        .element("td class=\"level\"", word(each.severity())).element("td", each.source()).markup("<td>")
        .text(each.words());
    if (each.times() > 1) {
      page.element("small", " " + each.times() + " times");
    }
    page.markup("</td></tr>");
  }

  private static String word(Severity severity) {
    return severity.compareTo(Severity.WARNING) < 0 ? "" : severity.name().toLowerCase(Locale.ROOT);
  }

  private void paths() {
    facts.paths().forEach((frame, paths) -> {
      page.markup("<section>").element("h2", "Driven path in " + (frame.isEmpty() ? "a frame without a name" : frame));
      new PathFigure(paths).draw(page);
      page.markup("</section>");
    });
  }

  private void figures() {
    if (!facts.series().isEmpty()) {
      page.markup("<section><h2>Speed and battery</h2>");
      SeriesFigure figure = new SeriesFigure(origin);
      facts.series().forEach(each -> figure.draw(page, each));
      page.markup("</section>");
    }
  }

  private void pictures() {
    for (CameraPictures camera : facts.cameras()) {
      page.markup("<section>").element("h2", camera.port()).markup("<div class=\"pictures\">");
      boolean all = true;
      for (CameraPictures.Taken each : camera.all()) {
        Optional<String> address = WebPicture.address(each.image());
        address.ifPresent(there -> page.markup("<figure><img alt=\"\" src=\"").markup(there).markup("\"/>")
            .element("figcaption", at(each.time())).markup("</figure>"));
        all &= address.isPresent();
      }
      page.markup("</div>");
      if (!all) {
        page.element("p", "Some of its pictures are left out: browsers do not show their encoding.");
      }
      page.markup("</section>");
    }
  }

  private void messages() {
    page.markup("<section><h2>Messages</h2>");
    new LaneFigure(facts.bins(), origin).draw(page, facts.topics());
    page.markup("<table><thead><tr><th>Topic</th><th>Type</th><th>Messages</th><th>Rate</th><th>Longest gap</th></tr>"
        + "</thead><tbody>");
    facts.topics().forEach(this::topic);
    page.markup("</tbody></table></section>");
  }

  private void topic(TopicTally each) {
    page.markup(each.hasGap() ? "<tr class=\"warning\">" : "<tr>").element("td", each.port())
        .element("td", each.type()).element("td class=\"number\"", Long.toString(each.count()))
        .element("td class=\"number\"", each.rate() == 0 ? "" : String.format(Locale.ROOT, "%.1f Hz", each.rate()))
        .element("td class=\"number\"", gap(each)).markup("</tr>");
  }

  private String gap(TopicTally each) {
    TimeRange gap = each.longestGap();
    return gap.length() == 0 ? ""
        : String.format(Locale.ROOT, "%.2f s", gap.length() / SECOND) + (each.hasGap() ? " at " + at(gap.start()) : "");
  }
}
