package org.robotui.lcm.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeParser;

/** Types as {@code lcm-gen} understands them. */
class TypesTest {

  private LcmWorld world;

  @BeforeEach
  void start() throws Exception {
    LcmInstallation.assumeThere();
    world = new LcmWorld();
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  /** Runs a script with the Python classes that {@code lcm-gen} makes of the types. */
  private List<String> python(String types, String script) throws Exception {
    Files.writeString(world.folder().resolve("types.lcm"), types);
    world.start("lcm-gen", "-p", "types.lcm").finish();
    return world.start("/usr/bin/python3", "-c", script).finish().lines().toList();
  }

  @Test
  void fingerprintsOfWildTypesAreTheSame() throws Exception {
    for (int seed = 0; seed < 8; seed++) {
      String text = RandomTypes.file(seed);
      TypeLibrary library = TypeLibrary.of(TypeParser.parse("types.lcm", text), List.of());
      assertEquals(List.of(), library.problems());
      List<String> theirs = python(text, """
          import importlib
          for number in range(%d):
              name = 'type_%%d' %% number
              kind = getattr(importlib.import_module('wild.' + name), name)
              print('wild.' + name, '0x' + kind._get_packed_fingerprint().hex())
          """.formatted(RandomTypes.COUNT));
      assertEquals(theirs, library.types().stream().map(LcmType::toString).toList(), text);
    }
  }
}
