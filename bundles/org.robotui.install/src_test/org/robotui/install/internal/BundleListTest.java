package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.install.internal.BundleList.Entry;

final class BundleListTest {
  @TempDir
  private Path folder;

  private BundleList list(String text) throws Exception {
    return BundleList.read(Files.writeString(folder.resolve("bundles.info"), text));
  }

  @Test
  void aReplacedBundleHasGoneAndCome() throws Exception {
    BundleList before =
        list("#encoding=UTF-8\n#version=1\na,1.0.0,plugins/a.jar,4,false\nb,1.0.0,plugins/b.jar,4,true\n");
    BundleList after = list("#encoding=UTF-8\na,2.0.0,plugins/a2.jar,4,false\nb,1.0.0,plugins/b.jar,5,true\n");

    assertEquals(Set.of(new Entry("a", "2.0.0")), after.without(before));
    assertEquals(Set.of(new Entry("a", "1.0.0")), before.without(after));
  }
}
