package org.robotui.ui.ask;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.ui.ask.Catalogue.Entry;
import org.robotui.ui.ask.Catalogue.Listing;

/**
 * The state of a view that asks: what there is, what is chosen, and what became of the questions. Safe for all threads.
 */
public final class AskModel {
  /**
   * What is to be shown.
   *
   * @param listing what there is
   * @param entries what of it passes the filter
   * @param filter the words of the filter
   * @param detail more about the chosen one
   * @param asked the questions, the newest first
   */
  public record Shown(Listing listing, List<Entry> entries, String filter, Optional<Detail> detail,
      List<Asked> asked) {}

  private final Catalogue catalogue;
  private final Questions questions;
  private volatile String filter = "";
  private volatile Optional<Detail> detail = Optional.empty();
  private Optional<Shown> last = Optional.empty(); // only in tick

  /**
   * Nothing is chosen yet.
   *
   * @param catalogue what there is
   * @param questions what is asked
   */
  public AskModel(Catalogue catalogue, Questions questions) {
    this.catalogue = catalogue;
    this.questions = questions;
  }

  /**
   * Looks for news.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return true where there is something else to show
   */
  public boolean tick(long nowNanos) {
    catalogue.tick(nowNanos);
    Shown now = shown();
    boolean open = now.asked().stream().anyMatch(Asked::running);
    boolean news = open || last.filter(now::equals).isEmpty();
    last = Optional.of(now);
    return news;
  }

  /**
   * What is to be shown now.
   *
   * @return the state
   */
  public Shown shown() {
    Listing listing = catalogue.listing();
    String words = filter.toLowerCase(Locale.ROOT);
    List<Entry> entries = words.isEmpty() ? listing.entries()
        : listing.entries().stream().filter(e -> text(e).contains(words)).toList();
    return new Shown(listing, entries, filter, detail, questions.asked());
  }

  private static String text(Entry entry) {
    return (entry.item().name() + " " + entry.item().type()).toLowerCase(Locale.ROOT);
  }

  /**
   * Lists only what contains some words.
   *
   * @param words the words
   */
  public void filter(String words) {
    filter = words.strip();
  }

  /**
   * Chooses what to ask.
   *
   * @param entry of the listing
   */
  public void choose(Entry entry) {
    if (detail.map(Detail::entry).filter(entry::equals).isEmpty()) {
      detail = Optional.of(new Detail.Asked(entry));
      describe(entry);
    }
  }

  /** Asks the robot again about what is chosen. */
  public void again() {
    detail.map(Detail::entry).ifPresent(this::describe);
  }

  private void describe(Entry entry) {
    catalogue.describe(entry, answer -> {
      if (detail.map(Detail::entry).filter(entry::equals).isPresent()) {
        detail = Optional.of(answer);
      }
    });
  }

  /**
   * The questions.
   *
   * @return what was asked and is asked
   */
  public Questions questions() {
    return questions;
  }
}
