package org.robotui.lcm.type;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** Fingerprints as {@code lcm-gen} 1.3.1 and 1.5.3 compute them. */
class FingerprintsTest {

  private static final Map<String, String> BY_LCM_GEN = Map.of(
      "zoo.scalars_t", "0xddc1449bae7d805a", "zoo.empty_t", "0x000000002468acf0", "zoo.arrays_t", "0xc26c4df508582d8e",
      "zoo.node_t", "0xa911de693d846b9a", "zoo.ping_t", "0x5ed42dc5b7db0356", "zoo.pong_t", "0x15e4048dda0cd8f4",
      "zoo.both_t", "0x0041c768146e2c4e", "zoo.state_t", "0xebec667d18748132", "other.thing_t", "0x4443a78061893aa8");

  static TypeLibrary zoo() {
    try (InputStream in = FingerprintsTest.class.getResourceAsStream("zoo.lcm")) {
      return TypeLibrary.of(TypeParser.parse("zoo.lcm", new String(in.readAllBytes(), StandardCharsets.UTF_8)),
          List.of());
    } catch (IOException | TypeException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void areThoseOfLcmGenAlsoWhereTypesHoldThemselves() {
    TypeLibrary zoo = zoo();
    assertEquals(List.of(), zoo.problems());
    BY_LCM_GEN.forEach((name, fingerprint) -> assertEquals(fingerprint,
        LcmType.hex(zoo.type(name).orElseThrow().fingerprint()), name));
    assertEquals(BY_LCM_GEN.size(), zoo.types().size());
  }

  @Test
  void typesThatDifferInTheirNamesOnlyShareOne() throws TypeException {
    TypeLibrary library = TypeLibrary
        .of(TypeParser.parse("twins.lcm", "struct one_t { double x; } struct two_t { double x; }"), List.of());
    assertEquals(List.of("one_t", "two_t"),
        library.withFingerprint(library.type("two_t").orElseThrow().fingerprint()).stream().map(LcmType::name)
            .toList());
  }

  /** Each type holds ten of the next: who walked all ways would walk ten to the power of forty. */
  @Test
  void typesThatMultiplyAreReadAtOnce() {
    TypeLibrary library = Assertions.assertTimeoutPreemptively(Duration.ofSeconds(60), () -> multiplied(""));
    assertTrue(library.problems().isEmpty() && library.types().size() == 41);
  }

  @Test
  void typesThatMultiplyAndReturnAreRefused() {
    TypeLibrary library =
        Assertions.assertTimeoutPreemptively(Duration.ofSeconds(60), () -> multiplied("int32_t n; t0 back[n];"));
    assertTrue(library.problems().stream().allMatch(problem -> problem.getMessage().contains("interwoven")),
        library.problems().toString());
    assertEquals(0, library.types().size());
  }

  private static TypeLibrary multiplied(String last) throws TypeException {
    StringBuilder text = new StringBuilder();
    for (int type = 0; type < 40; type++) {
      text.append("struct t").append(type).append(" { int32_t n;");
      for (int member = 0; member < 10; member++) {
        text.append(" t").append(type + 1).append(" m").append(member).append("[n];");
      }
      text.append(" }\n");
    }
    return TypeLibrary.of(TypeParser.parse("many.lcm", text + "struct t40 {" + last + "}"), List.of());
  }
}
