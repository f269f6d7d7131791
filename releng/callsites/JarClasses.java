package callsites;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.tree.ClassNode;

/** The classes of one jar, and those that replace their lambdas. */
final class JarClasses {
  private static final String CLASS = ".class";

  private final Map<String, ClassNode> present = new LinkedHashMap<>();

  private final Map<String, byte[]> added = new LinkedHashMap<>();

  private final Set<String> changed = new HashSet<>();

  private JarClasses() {}

  static void link(Path jar, ClassIndex index) throws IOException {
    Path linked = jar.resolveSibling(jar.getFileName() + ".linked");
    try (ZipFile from = new ZipFile(jar.toFile());
        OutputStream out = Files.newOutputStream(linked);
        ZipOutputStream to = new ZipOutputStream(out)) {
      JarClasses classes = new JarClasses();
      classes.read(from);
      classes.present.values().forEach(type -> classes.link(type, index));
      classes.write(from, to);
    }
    Files.move(linked, jar, StandardCopyOption.REPLACE_EXISTING);
  }

  private void link(ClassNode type, ClassIndex index) {
    if (new HostClass(type, new Access(index, type)).link(this::add)) {
      changed.add(type.name);
    }
  }

  private void add(ClassNode host, String name, byte[] content) {
    added.put(name, content);
    present.get(Access.nestOf(host)).visitNestMember(name);
    changed.add(Access.nestOf(host));
  }

  private void read(ZipFile from) throws IOException {
    for (ZipEntry entry : from.stream().filter(JarClasses::isClass).toList()) {
      try (InputStream content = from.getInputStream(entry)) {
        ClassNode type = new ClassNode();
        new ClassReader(content).accept(type, 0);
        present.put(type.name, type);
      }
    }
  }

  private void write(ZipFile from, ZipOutputStream to) throws IOException {
    long time = 0;
    for (ZipEntry entry : from.stream().toList()) {
      time = entry.getTime();
      byte[] content = from.getInputStream(entry).readAllBytes();
      String type = entry.getName().replaceFirst("\\.class$", "");
      put(to, entry.getName(), time, changed.contains(type) ? written(type) : content);
    }
    for (Map.Entry<String, byte[]> type : added.entrySet()) {
      put(to, type.getKey() + CLASS, time, type.getValue());
    }
  }

  private byte[] written(String type) {
    ClassWriter out = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    present.get(type).accept(out);
    return out.toByteArray();
  }

  private static void put(ZipOutputStream to, String name, long time, byte[] content) throws IOException {
    ZipEntry entry = new ZipEntry(name);
    entry.setTime(time);
    to.putNextEntry(entry);
    to.write(content);
    to.closeEntry();
  }

  private static boolean isClass(ZipEntry entry) {
    return entry.getName().endsWith(CLASS) && !entry.getName().endsWith("-info.class");
  }
}
