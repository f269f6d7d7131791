package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.tree.BodyMessage;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.tree.BodyUnit;
import org.robotui.roblets.tree.BodyXml;
import org.robotui.roblets.tree.BodyXmlException;
import org.robotui.roblets.tree.RecordMessage;

/** Messages as trees: read, written, asked, and made of records. */
class BodyTreeTest {
  private static final String BODY = "<body><gps><position lat='43.7' lon='10.4'/><time>12</time></gps>"
      + "<wind><air unit='kn' speed='8'/><air unit='m/s' speed='4'/></wind><gps2><position lat='1'/></gps2></body>";

  private final BodyXml xml = new BodyXml();

  enum Tack {
    PORT, STARBOARD
  }

  record Leg(double length, int count) {}

  @BodyMessage(value = "course", as = "heading")
  record Course(@BodyUnit("deg") double heading, boolean steered, String sailor, Tack tack, Leg leg) {}

  private BodyElement read(String text) throws BodyXmlException {
    return xml.read(text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void what_is_written_is_read_as_the_same() throws BodyXmlException {
    Random random = new Random(3);
    for (int i = 0; i < 200; i++) {
      BodyElement made = made(random, 0);
      assertEquals(made, xml.read(BodyXml.bytes(made)));
    }
  }

  private static BodyElement made(Random random, int depth) {
    String odd = new String(random.ints(8, 32, 0x2fff).toArray(), 0, 8) + "<&\"'>\n";
    List<BodyElement> children = depth > 4 ? List.of()
        : random.ints(random.nextInt(4), 0, 9).mapToObj(i -> made(random, depth + 1)).toList();
    return new BodyElement("e" + random.nextInt(9), Map.of("a", odd, "b", "" + random.nextDouble()), odd,
        children);
  }

  @Test
  void paths_lead_to_elements_attributes_and_texts() throws BodyXmlException {
    BodyElement body = read(BODY);
    assertEquals(List.of("43.7"), BodyPath.parse("gps/position/@lat").values(body));
    assertEquals(List.of("43.7", "1"), BodyPath.parse("//position/@lat").values(body));
    assertEquals(List.of("12"), BodyPath.parse("/gps/time/text()").values(body));
    assertEquals(4, BodyPath.parse("wind/air[@unit='m/s']/@speed").number(body).orElseThrow());
    assertEquals(4, BodyPath.parse("wind/air[2]/@speed").number(body).orElseThrow());
    assertEquals(List.of("43.7", "1"), BodyPath.parse("*/position[@lat]/@lat").values(body));
    assertEquals(4, BodyPath.parse("*/*").elements(body).size() - 1);
    assertTrue(BodyPath.parse("gps/nothing").elements(body).isEmpty());
  }

  @Test
  void what_is_no_path_is_refused_with_the_place() {
    for (String wrong : List.of("", "/", "gps/", "gps//", "@lat", "gps[", "gps[0]", "gps position", "a/b[@c=d]",
        "a/".repeat(20) + "a", "a".repeat(400))) {
      IllegalArgumentException refused =
          assertThrows(IllegalArgumentException.class, () -> BodyPath.parse(wrong), wrong);
      assertTrue(refused.getMessage().contains("path"), refused.getMessage());
    }
  }

  @Test
  void records_become_messages_and_back() {
    Course course = new Course(271.5, true, "Ada", Tack.PORT, new Leg(12.25, 3));
    RecordMessage<Course> messages = RecordMessage.of(Course.class);
    BodyElement element = messages.element(course);
    assertEquals("<course heading=\"271.5\" steered=\"true\" sailor=\"Ada\" tack=\"PORT\">"
        + "<leg length=\"12.25\" count=\"3\"/></course>", BodyXml.text(element));
    assertEquals(course, messages.record(element));
    assertEquals(new BodyForm.Field("heading", "number", "deg"), messages.form().fields().getFirst());
    assertEquals(List.of("heading", "steered", "sailor", "tack", "leg/length", "leg/count"),
        messages.form().fields().stream().map(BodyForm.Field::name).toList());
    assertEquals(messages.form(), BodyForm.of(messages.form().element("output")));
    String said = assertThrows(IllegalArgumentException.class,
        () -> messages.record(element.with("heading", "north"))).getMessage();
    assertTrue(said.contains("course") && said.contains("heading"), said);
  }

  @Test
  void bombs_and_what_is_too_much_are_refused() {
    String bomb = "<!DOCTYPE r4n [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]><r4n>&b;</r4n>";
    String file = "<!DOCTYPE r4n [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><r4n>&a;</r4n>";
    String many = "<a>" + "<b/>".repeat(BodyXml.MOST_ELEMENTS) + "</a>";
    String deep = "<a>".repeat(BodyXml.DEEPEST + 1) + "</a>".repeat(BodyXml.DEEPEST + 1);
    for (String wrong : List.of(bomb, file, many, deep, "<a>", "", "a", "<a/><b/>", "<a b='1' b='2'/>",
        "<a>&nothing;</a>", "<a:b c='d'/>", "<" + "n".repeat(70) + "/>", "<a>" + "x".repeat(70_000) + "</a>",
        "<?xml version='1.0' encoding='UTF-16'?><a>\u0001</a>")) {
      assertThrows(BodyXmlException.class, () -> read(wrong), wrong.substring(0, Math.min(60, wrong.length())));
    }
  }
}
