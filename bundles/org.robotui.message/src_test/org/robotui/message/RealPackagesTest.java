package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

/** Compares with the Python packages of ROS, where they are installed: sums and full texts with all their comments. */
class RealPackagesTest {

  private static final Path PYTHON = Path.of("/usr/bin/python3");
  private static final Pattern NESTED = Pattern.compile("(?m)^MSG: (\\S+)$");
  private static final String DUMP = """
      import base64, importlib, inspect
      for package in ('std_msgs', 'geometry_msgs', 'nav_msgs', 'sensor_msgs', 'tf2_msgs', 'rosgraph_msgs',
                      'diagnostic_msgs', 'actionlib_msgs', 'visualization_msgs', 'roscpp', 'std_srvs'):
          try:
              module = importlib.import_module(package + '.msg')
          except ImportError:
              continue
          for name, c in inspect.getmembers(module, inspect.isclass):
              print(c._type, c._md5sum, base64.b64encode(c._full_text.encode()).decode() or '-')
      """;

  private static final String REENCODE = """
      import base64, importlib, io, sys
      for line in sys.stdin:
          type, data = line.split(' ')
          package, name = type.split('/')
          c = getattr(importlib.import_module(package + '.msg'), name)
          out = io.BytesIO()
          c().deserialize(base64.b64decode(data)).serialize(out)
          print(type, base64.b64encode(out.getvalue()).decode())
      """;

  private static List<String> python(String script, String input) throws IOException, InterruptedException {
    Assumptions.assumeTrue(Files.isExecutable(PYTHON), "no " + PYTHON);
    Path lines = Files.createTempFile("messages", ".txt");
    try {
      Files.writeString(lines, input);
      Process python = new ProcessBuilder(PYTHON.toString(), "-c", script).redirectInput(lines.toFile())
          .redirectError(ProcessBuilder.Redirect.DISCARD).start();
      String output = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(0, python.waitFor(), "the real packages refused a message after " + output.lines().count());
      return output.lines().toList();
    } finally {
      Files.delete(lines);
    }
  }

  private static List<String[]> realTypes() throws IOException, InterruptedException {
    List<String[]> types = python(DUMP, "").stream().map(line -> line.split(" ")).toList();
    Assumptions.assumeTrue(!types.isEmpty(), "no ROS packages for " + PYTHON);
    return types;
  }

  private static String text(String base64) {
    return base64.equals("-") ? "" : new String(Base64.getDecoder().decode(base64), StandardCharsets.UTF_8);
  }

  private static List<String> nested(String fullText) {
    return NESTED.matcher(fullText).results().map(r -> r.group(1)).toList();
  }

  @Test
  void theRealCodecsReadWhatOursWriteAndWriteTheSame() throws Exception {
    RandomTrees trees = new RandomTrees(new SplittableRandom(11));
    List<String> sent = new ArrayList<>();
    for (String[] each : realTypes()) {
      DynamicCodec dynamic = new DynamicCodec(ShippedDefinitions.schema(each[0]));
      DynamicMessage message = dynamic.build(trees.tree(ShippedDefinitions.schema(each[0]).layout()));
      MessageWriter out = new MessageWriter();
      dynamic.encode(message, out);
      sent.add(each[0] + " " + Base64.getEncoder().encodeToString(out.toByteArray()));
    }
    assertEquals(sent, python(REENCODE, String.join("\n", sent)));
  }

  @Test
  void sumsAndTheOrderOfNestedTypesAreThoseOfTheRealGenerator() throws Exception {
    List<String[]> types = realTypes();
    ShippedDefinitions shipped = new ShippedDefinitions();
    for (String[] each : types) {
      String real = text(each[2]);
      assertEquals(each[1], MessageSchema.parse(each[0], real).info().md5(), each[0]);
      MessageInfo ours = MessageSchema.resolve(shipped.find(each[0]).orElseThrow(), shipped).info();
      assertEquals(nested(real), nested(ours.definition()), each[0]);
    }
    assertTrue(types.size() > 100, "only " + types.size() + " types");
  }
}
