package org.robotui.ros.internal.xmlrpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.ros.XmlRpcValue;
import org.robotui.testkit.Effort;

class XmlRpcTest {

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static XmlRpcValue value(String xml) throws Exception {
    return XmlRpcReader.response(utf8("<methodResponse><params><param>" + xml + "</param></params></methodResponse>"));
  }

  private static String problem(String document) {
    return assertThrows(XmlRpcException.class, () -> XmlRpcReader.call(utf8(document))).getMessage();
  }

  @Test
  void aCallOfPythonIsRead() throws Exception {
    MethodCall call = XmlRpcReader.call(utf8("""
        <?xml version='1.0'?>
        <methodCall>
        <methodName>registerPublisher</methodName>
        <params>
        <param>
        <value><string>/a &lt;&amp;&#228;</string></value>
        </param>
        <param>
        <value><array><data>
        <value><int>-7</int></value>
        <value><boolean>1</boolean></value>
        </data></array></value>
        </param>
        </params>
        </methodCall>
        """));
    assertEquals(new MethodCall("registerPublisher", List.of(XmlRpcValue.of("/a <&ä"),
        XmlRpcValue.of(XmlRpcValue.of(-7), XmlRpcValue.of(true)))), call);
  }

  @Test
  void aCallOfRoscppIsRead() throws Exception {
    MethodCall call =
        XmlRpcReader.call(utf8("<?xml version=\"1.0\"?>\r\n<methodCall><methodName>getPid</methodName>\r\n"
            + "<params><param><value>/node</value></param></params></methodCall>\r\n"));
    assertEquals(new MethodCall("getPid", List.of(XmlRpcValue.of("/node"))), call);
  }

  @Test
  void aCallWithoutParametersIsRead() throws Exception {
    assertEquals(new MethodCall("a", List.of()),
        XmlRpcReader.call(utf8("<methodCall><methodName>a</methodName></methodCall>")));
  }

  @ParameterizedTest
  @CsvSource({"' a b ',' a b '", "<string/>,''", "<string> x</string>,' x'", "'',''", "'<![CDATA[<a>&]]>',<a>&",
      "a<!-- no -->b,ab"})
  void stringsAreKeptAsTheyAre(String xml, String text) throws Exception {
    assertEquals(XmlRpcValue.of(text), value("<value>" + xml + "</value>"));
  }

  @ParameterizedTest
  @CsvSource({"nan,NaN", "inf,Infinity", "-inf,-Infinity", "1e-3,0.001", "-2,-2"})
  void doublesOfCAndPythonAreRead(String text, double number) throws Exception {
    assertEquals(XmlRpcValue.of(number), value("<value><double>" + text + "</double></value>"));
  }

  @Test
  void aFaultIsAnException() {
    byte[] fault = XmlRpcWriter.fault(new XmlRpcFault(7, "no such <thing>"));
    XmlRpcFault read = assertThrows(XmlRpcFault.class, () -> XmlRpcReader.response(fault));
    assertEquals("7 no such <thing>", read.code() + " " + read.getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"<int>1.5</int>", "<int>99999999999</int>", "<int/>", "<boolean>2</boolean>",
      "<double>x</double>",
      "<base64>*</base64>", "<i9>1</i9>", "<int a='1'>1</int>", "<array></array>", "<struct><member/></struct>",
      "<int>1", "<string>&unknown;</string>", "<string>&</string>", "<string>&#x110000;</string>", "<!--"})
  void malformedValuesAreRefused(String xml) {
    assertThrows(XmlRpcException.class, () -> value("<value>" + xml + "</value>"));
  }

  @Test
  void documentTypesAreRefusedSoThatNothingExpands() {
    assertTrue(
        problem("<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b \"cc\">]><methodCall/>").contains("document types"));
  }

  @Test
  void nestingIsBounded() {
    String deep = "<value><array><data>".repeat(100_000);
    assertTrue(
        problem("<methodCall><methodName>a</methodName><params><param>" + deep).contains("nested deeper than 64"));
  }

  @Test
  void otherEncodingsThanUtf8AreRefused() {
    assertThrows(XmlRpcException.class, () -> XmlRpcReader.call(new byte[]{(byte) 0xff, (byte) 0xfe, 0}));
  }

  @Test
  void errorsTellThePlace() {
    assertEquals("expected <methodCall> at character 2", problem("  <x/>"));
    assertTrue(problem("<methodCall><methodName>a</methodName></methodCall>x")
        .startsWith("unexpected content after the document"));
  }

  @Test
  void whatIsWrittenIsReadBack() throws Exception {
    Random random = new Random(1);
    for (int i = 0; i < 2_000; i++) {
      XmlRpcValue value = randomValue(random, 0);
      assertEquals(value, XmlRpcReader.response(XmlRpcWriter.response(value)));
      assertEquals(new MethodCall("m", List.of(value, value)),
          XmlRpcReader.call(XmlRpcWriter.call(new MethodCall("m", List.of(value, value)))));
    }
  }

  @Test
  void mutatedDocumentsAreReadOrRefusedButNeverCrash() {
    Random random = new Random(2);
    Effort effort = Effort.of(30_000, Duration.ofMinutes(5));
    int refused = 0;
    while (effort.goesOn()) {
      byte[] document = mutate(XmlRpcWriter.call(new MethodCall("m", List.of(randomValue(random, 0)))), random);
      try {
        XmlRpcReader.call(document);
      } catch (XmlRpcException e) {
        refused++;
      }
    }
    assertTrue(refused > effort.rounds() / 3 && refused < effort.rounds(), "refused " + refused);
  }

  private static byte[] mutate(byte[] document, Random random) {
    byte[] out = document.clone();
    for (int n = 1 + random.nextInt(3); n > 0; n--) {
      int at = random.nextInt(out.length);
      switch (random.nextInt(4)) {
        case 0 -> out[at] = (byte) random.nextInt(256);
        case 1 -> out[at] = (byte) "<>/&;#x0\"'! ".charAt(random.nextInt(12));
        case 2 -> out = java.util.Arrays.copyOf(out, at + 1);
        default -> System.arraycopy(out, at, out, random.nextInt(at + 1), Math.min(20, out.length - at));
      }
    }
    return out;
  }

  private static XmlRpcValue randomValue(Random random, int depth) {
    return switch (random.nextInt(depth > 3 ? 6 : 8)) {
      case 0 -> XmlRpcValue.of(random.nextInt());
      case 1 -> XmlRpcValue.of(random.nextBoolean());
      case 2 -> XmlRpcValue.of(Double.longBitsToDouble(random.nextLong() & 0x7fefffffffffffffL));
      case 3 -> XmlRpcValue.of(randomText(random));
      case 4 -> new XmlRpcValue.DateTime("20260131T12:00:00");
      case 5 -> new XmlRpcValue.Binary(utf8(randomText(random)));
      case 6 -> randomArray(random, depth);
      default -> randomStruct(random, depth);
    };
  }

  private static XmlRpcValue randomArray(Random random, int depth) {
    List<XmlRpcValue> items = new ArrayList<>();
    for (int n = random.nextInt(4); n > 0; n--) {
      items.add(randomValue(random, depth + 1));
    }
    return new XmlRpcValue.Array(items);
  }

  private static XmlRpcValue randomStruct(Random random, int depth) {
    Map<String, XmlRpcValue> members = new LinkedHashMap<>();
    for (int n = random.nextInt(4); n > 0; n--) {
      members.put(randomText(random), randomValue(random, depth + 1));
    }
    return new XmlRpcValue.Struct(members);
  }

  private static String randomText(Random random) {
    StringBuilder text = new StringBuilder();
    for (int n = random.nextInt(8); n > 0; n--) {
      text.appendCodePoint("ab <>&\"'\r\n\täß😀]".codePoints().toArray()[random.nextInt(15)]);
    }
    return text.toString();
  }
}
