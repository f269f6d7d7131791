package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.ProtocolException;
import org.robotui.ros.internal.xmlrpc.XmlRpcException;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcReader;
import org.robotui.testkit.Effort;

/** Every decoder of bytes from the network: what is kept in the corpus, and what grows from it by chance. */
class CorpusTest {

  private static final int LIMIT = 1 << 20;
  private static final String NESTED =
      "Part[] parts\nstring[2] names\nfloat64[] numbers\n===\nMSG: p/Part\nuint8[] bytes\nstring name\n";
  private static final Map<String, Corpus.Decoder> DECODERS = Map.of(
      "call", CorpusTest::call, "response", CorpusTest::response, "header", CorpusTest::header, "frames",
      CorpusTest::frames,
      "definition", CorpusTest::definition, "message", CorpusTest::message);

  static Stream<String> decoders() {
    return DECODERS.keySet().stream().sorted();
  }

  private static boolean call(byte[] input) {
    try {
      return !XmlRpcReader.call(input).toString().isEmpty();
    } catch (XmlRpcException e) {
      return false;
    }
  }

  private static boolean response(byte[] input) {
    try {
      return !XmlRpcReader.response(input).toString().isEmpty();
    } catch (XmlRpcException | XmlRpcFault e) {
      return false;
    }
  }

  private static boolean header(byte[] input) {
    try {
      return ConnectionHeader.decode(input).field("callerid").isPresent();
    } catch (ProtocolException e) {
      return false;
    }
  }

  private static boolean frames(byte[] input) {
    FrameReader reader = new FrameReader(new ByteArrayInputStream(input), 64);
    try {
      while (true) {
        reader.next(LIMIT, "frame");
      }
    } catch (IOException e) {
      return e.getMessage().equals("closed by the peer");
    }
  }

  private static boolean definition(byte[] input) {
    try {
      return !MessageSchema.parse("p/Fuzzed", new String(input, StandardCharsets.UTF_8)).info().md5().isEmpty();
    } catch (DefinitionException e) {
      return false;
    }
  }

  private static boolean message(byte[] input) {
    try {
      return new DynamicCodec(MessageSchema.parse("p/Fuzzed", NESTED)).decode(ByteBuffer.wrap(input)).fields()
          .size() == 3;
    } catch (MessageException e) {
      return false;
    } catch (DefinitionException e) {
      throw new IllegalStateException(e);
    }
  }

  @ParameterizedTest
  @MethodSource("decoders")
  @Timeout(20)
  void whatIsKeptIsDecodedOrRefusedAsItsNameSays(String name) throws IOException {
    List<Path> files = Corpus.of(name);
    assertTrue(files.size() >= 3, "the corpus of " + name + " is too small to grow from");
    for (Path file : files) {
      boolean accepted = Corpus.accepts(name, DECODERS.get(name), Files.readAllBytes(file));
      boolean expected = file.getFileName().toString().startsWith("good");
      assertTrue(accepted == expected, file + (accepted ? " is accepted" : " is refused"));
    }
  }

  @ParameterizedTest
  @MethodSource("decoders")
  @Timeout(1_200)
  void whatGrowsFromItIsDecodedOrRefused(String name) throws IOException {
    Random random = new Random(name.hashCode());
    List<byte[]> seeds = seeds(name);
    Effort effort = Effort.of(20_000, Duration.ofMinutes(5));
    int accepted = 0;
    while (effort.goesOn()) {
      byte[] input = grown(seeds.get(random.nextInt(seeds.size())), seeds.get(random.nextInt(seeds.size())), random);
      accepted += Corpus.accepts(name, DECODERS.get(name), input) ? 1 : 0;
    }
    assertTrue(accepted > 0 && accepted < effort.rounds(), accepted + " of " + effort.rounds() + " were accepted");
  }

  private static List<byte[]> seeds(String name) throws IOException {
    List<byte[]> seeds = new java.util.ArrayList<>();
    for (Path file : Corpus.of(name)) {
      seeds.add(Files.readAllBytes(file));
    }
    return seeds;
  }

  /** Parts of two inputs, with some bytes changed. */
  private static byte[] grown(byte[] one, byte[] other, Random random) {
    byte[] input = random.nextInt(3) == 0 ? joined(one, other, random) : one.clone();
    for (int n = random.nextInt(4); n > 0 && input.length > 0; n--) {
      int at = random.nextInt(input.length);
      switch (random.nextInt(4)) {
        case 0 -> input[at] = (byte) random.nextInt();
        case 1 -> input[at] ^= (byte) (1 << random.nextInt(8));
        case 2 -> Arrays.fill(input, at, Math.min(input.length, at + 4), (byte) (random.nextBoolean() ? -1 : 0));
        default -> input = Arrays.copyOf(input, at + random.nextInt(8));
      }
    }
    return input;
  }

  private static byte[] joined(byte[] one, byte[] other, Random random) {
    int head = random.nextInt(one.length + 1);
    int from = random.nextInt(other.length + 1);
    byte[] input = Arrays.copyOf(one, head + other.length - from);
    System.arraycopy(other, from, input, head, other.length - from);
    return input;
  }

  /** Each type holds ten of the next: what is expanded without memory would be ten to the power of forty. */
  @Test
  @Timeout(20)
  void definitionsThatMultiplyAreReadOrRefusedAtOnce() {
    StringBuilder text = new StringBuilder();
    for (int type = 0; type < 40; type++) {
      text.append(type == 0 ? "" : "===\nMSG: p/T" + type + "\n");
      for (int field = 0; field < 10; field++) {
        text.append("T").append(type + 1).append(" f").append(field).append('\n');
      }
    }
    text.append("===\nMSG: p/T40\nint8 x\n");
    Corpus.accepts("definition", CorpusTest::definition, text.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Elements without bytes: any number of them would fit into nothing. */
  @ParameterizedTest
  @ValueSource(strings = {"N[] n\n===\nMSG: p/N\n", "N[999999999] n\n===\nMSG: p/N\n",
      "A[] a\n===\nMSG: p/A\nN[1000] n\n===\nMSG: p/N\n"})
  @Timeout(20)
  void arraysOfNothingAreBounded(String definition) {
    byte[] many = {-1, -1, -1, 0x7f};
    assertFalse(accepts(definition, many));
  }

  private static boolean accepts(String definition, byte[] message) {
    try {
      new DynamicCodec(MessageSchema.parse("p/Fuzzed", definition)).decode(ByteBuffer.wrap(message));
      return true;
    } catch (MessageException | DefinitionException e) {
      return false;
    }
  }
}
