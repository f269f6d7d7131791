package org.robotui.condition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words of a condition, with where they stand. */
final class ConditionWords {
  /**
   * A word.
   *
   * @param text without quotes
   * @param quoted whether it stood in quotes, and so is a word of the robot's
   * @param column from 1
   */
  record Piece(String text, boolean quoted, int column) {
    boolean is(String word) {
      return !quoted && text.equalsIgnoreCase(word);
    }

    Optional<Comparison> comparison() {
      return quoted ? Optional.empty() : Comparison.find(text);
    }
  }

  /** Signs that are no part of names stand alone, as do - and / where blanks are around them. */
  private static final Pattern PIECE =
      Pattern.compile("\"([^\"]*)\"|'([^']*)'|(<=|>=|==|!=|[<>()+*,]|[-/](?=\\s))|([^\\s\"'<>=!()+*,]+)|(\\S)");
  private static final Set<String> COMBINING = Set.of("and", "or", "not", "(", ")", "+", "-", "*", "/", ",");

  private final String text;
  private final List<Piece> pieces = new ArrayList<>();
  private int at;

  ConditionWords(String text) {
    this.text = text;
    Matcher matcher = PIECE.matcher(text);
    while (matcher.find()) {
      boolean quoted = matcher.group(1) != null || matcher.group(2) != null;
      String piece = quoted ? matcher.group().substring(1, matcher.group().length() - 1) : matcher.group();
      pieces.add(new Piece(piece, quoted, matcher.start() + 1));
    }
    pieces.add(new Piece("", true, text.length() + 1));
  }

  /** Whether it is more than one of the plain forms. */
  boolean combine() {
    return pieces.stream().anyMatch(piece -> COMBINING.stream().anyMatch(piece::is));
  }

  /** All of them as they stand, without quotes. */
  List<String> texts() {
    return new ArrayList<>(pieces.subList(0, pieces.size() - 1).stream().map(Piece::text).toList());
  }

  /** The next word; an empty one at the end. */
  Piece next() {
    return ahead(0);
  }

  /** A word behind the next one. */
  Piece ahead(int count) {
    return pieces.get(Math.min(at + count, pieces.size() - 1));
  }

  boolean atEnd() {
    return at >= pieces.size() - 1;
  }

  Piece take() {
    Piece taken = next();
    at = Math.min(at + 1, pieces.size() - 1);
    return taken;
  }

  /** Takes a word if it is the next. */
  boolean take(String word) {
    boolean there = next().is(word);
    if (there) {
      take();
    }
    return there;
  }

  void require(String word) {
    if (!take(word)) {
      throw wrong("here '" + word + "' is missing");
    }
  }

  /** Something is wrong with the next word. */
  IllegalArgumentException wrong(String why) {
    return wrong(next(), why);
  }

  IllegalArgumentException wrong(Piece piece, String why) {
    String where = piece.column() > text.length() ? "its end" : "'" + piece.text() + "'";
    return new IllegalArgumentException("'" + text + "', column " + piece.column() + " (" + where + "): " + why);
  }
}
