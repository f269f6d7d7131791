package org.robotui.roblets.wire;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyXml;
import org.robotui.roblets.tree.BodyXmlException;

/**
 * One datagram: {@code <r4n kind="message" from="gps" run="1700000000123" seq="17" at="1700000000.5" to="brain">} with
 * one element in it.
 *
 * @param kind what it is for
 * @param from who says it
 * @param run when the sender started, milliseconds of its clock since the epoch: a sender that was started again has a
 * greater one
 * @param sequence counts the datagrams of one run to one receiver, from 1 on
 * @param stampNanos when it was said, nanoseconds since the epoch; 0 where that is not known
 * @param to for whom it is
 * @param body what it says; none where its kind says it all
 */
public record BodyDatagram(DatagramKind kind, String from, long run, long sequence, long stampNanos, String to,
    Optional<BodyElement> body) {
  /** The port of a brain, where nothing else is said. */
  public static final int BRAIN_PORT = 7852;

  /** The variable that says where the brain of a robot is, {@code HOST:PORT}. */
  public static final String BRAIN_VARIABLE = "ROBLETS_BRAIN";

  private static final String ROOT = "r4n";
  private static final int LONGEST_NUMBER = 32;
  private static final BigDecimal LAST = new BigDecimal("9000000000");

  /**
   * Checks names and counts.
   *
   * @param kind what it is for
   * @param from who says it
   * @param run when the sender started
   * @param sequence counts
   * @param stampNanos when it was said
   * @param to for whom
   * @param body what it says
   * @throws IllegalArgumentException where they are none
   */
  public BodyDatagram {
    BodyElement.checked(from);
    BodyElement.checked(to);
    if (run < 0 || sequence < 0 || stampNanos < 0) {
      throw new IllegalArgumentException("run, seq and at of a datagram are not negative");
    }
  }

  /**
   * Writes it.
   *
   * @return its bytes
   * @throws IllegalArgumentException where they are too many for a datagram
   */
  public byte[] bytes() {
    BodyElement root = BodyElement.of(ROOT).with("kind", kind.word()).with("from", from).with("run", run)
        .with("seq", sequence).with("at", BigDecimal.valueOf(stampNanos, 9).toPlainString()).with("to", to);
    return BodyXml.bytes(root.with(body.map(List::of).orElse(List.of())));
  }

  /**
   * Reads one.
   *
   * @param bytes as they came
   * @param xml reads XML
   * @return the datagram
   * @throws BodyXmlException where it is none
   */
  public static BodyDatagram of(byte[] bytes, BodyXml xml) throws BodyXmlException {
    BodyElement root = xml.read(bytes);
    DatagramKind kind = DatagramKind.of(root.attribute("kind").orElse(""))
        .filter(known -> root.name().equals(ROOT) && root.children().size() <= 1)
        .orElseThrow(() -> new BodyXmlException("no datagram of roblets: the element is '" + root.name()
            + "', or its kind is not known, or it holds more than one element"));
    try {
      return new BodyDatagram(kind, root.attribute("from").orElse(""), count(root, "run"), count(root, "seq"),
          stamp(root.attribute("at").orElse("0")), root.attribute("to").orElse("brain"),
          root.children().stream().findFirst());
    } catch (IllegalArgumentException | ArithmeticException e) {
      throw new BodyXmlException("no datagram of roblets: " + e.getMessage());
    }
  }

  private static long count(BodyElement root, String attribute) {
    String text = root.attribute(attribute).orElse("");
    if (!text.matches("[0-9]{1,18}")) {
      throw new IllegalArgumentException("'" + attribute + "' is no count");
    }
    return Long.parseLong(text);
  }

  private static long stamp(String text) {
    if (text.length() > LONGEST_NUMBER || !text.matches("[0-9]+(\\.[0-9]+)?")) {
      throw new IllegalArgumentException("'at' is no time in seconds");
    }
    BigDecimal seconds = new BigDecimal(text);
    return seconds.compareTo(LAST) > 0 ? 0 : seconds.movePointRight(9).longValue();
  }
}
