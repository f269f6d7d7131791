package org.robotui.uic.tftree.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.data.FrameId;

/**
 * What is asked for.
 *
 * @param words all of which must be in the name of a frame or of who sends it, in lower case
 * @param problems whether only frames with a problem are wanted
 * @param closed frames below which nothing is shown
 * @param selected whose pose is shown
 * @param reference in which frame
 * @param drawn whether the tree is drawn, else listed
 */
public record Ask(List<String> words, boolean problems, Set<FrameId> closed, Optional<FrameId> selected,
    Reference reference, boolean drawn) {
  /** At first. */
  public static final Ask FIRST = new Ask(List.of(), false, Set.of(), Optional.empty(), new Reference.Root(), true);

  private static final int MOST_CLOSED = 5000;

  /** Copies the collections. */
  public Ask {
    words = List.copyOf(words);
    closed = Set.copyOf(closed);
  }

  /** In which frame a pose is shown. */
  public sealed interface Reference {
    /** The root of the frame's tree. */
    record Root() implements Reference {}

    /** The frame that carries it. */
    record Parent() implements Reference {}

    /**
     * Always the same.
     *
     * @param frame which
     */
    record Pinned(FrameId frame) implements Reference {}
  }

  /** With other words. */
  public Ask search(String typed) {
    List<String> next =
        Stream.of(typed.toLowerCase(Locale.ROOT).split("\\s+")).filter(word -> !word.isEmpty()).toList();
    return new Ask(next, problems, closed, selected, reference, drawn);
  }

  /** With problems only, or all. */
  public Ask problems(boolean only) {
    return new Ask(words, only, closed, selected, reference, drawn);
  }

  /** With what is below a frame shown or not. */
  public Ask toggle(FrameId frame) {
    Set<FrameId> next = new HashSet<>(closed);
    if (!next.remove(frame) && next.size() < MOST_CLOSED) {
      next.add(frame);
    }
    return new Ask(words, problems, next, selected, reference, drawn);
  }

  /** With everything open. */
  public Ask opened() {
    return new Ask(words, problems, Set.of(), selected, reference, drawn);
  }

  /** With another frame selected. */
  public Ask select(Optional<FrameId> frame) {
    return new Ask(words, problems, closed, frame, reference, drawn);
  }

  /** With poses in another frame. */
  public Ask in(Reference next) {
    return new Ask(words, problems, closed, selected, next, drawn);
  }

  /** Drawn or listed. */
  public Ask drawn(boolean wanted) {
    return new Ask(words, problems, closed, selected, reference, wanted);
  }

  /** Whether frames are left out. */
  public boolean narrows() {
    return problems || !words.isEmpty();
  }

  boolean fits(FrameRow row) {
    if (problems && !row.isProblem()) {
      return false;
    }
    String text = (row.id() + " " + row.link().map(link -> link.authority()).orElse("")).toLowerCase(Locale.ROOT);
    return words.stream().allMatch(text::contains);
  }
}
