package callsites;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

/** The classes of some jars and of Java itself, without their code; a jar that is read stays open until the end. */
final class ClassIndex implements AutoCloseable {
  private static final String CLASS = ".class";

  private static final int NEWEST = Opcodes.V25;

  private final List<ZipFile> jars = new ArrayList<>();

  private final Map<String, ZipFile> places = new HashMap<>();

  private final Map<String, Optional<ClassNode>> known = new HashMap<>();

  ClassIndex(List<Path> files) throws IOException {
    for (Path file : files) {
      ZipFile jar = new ZipFile(file.toFile());
      jars.add(jar);
      jar.stream().map(ZipEntry::getName).filter(name -> name.endsWith(CLASS))
          .forEach(name -> places.putIfAbsent(name.substring(0, name.length() - CLASS.length()), jar));
    }
  }

  /** The class with this internal name. */
  Optional<ClassNode> find(String name) {
    Optional<ClassNode> found = known.get(name);
    if (found == null) {
      found = read(name);
      known.put(name, found);
    }
    return found;
  }

  /** The class that declares the method, as the virtual machine looks for it from its owner. */
  Optional<Declared> declared(String owner, String name, String descriptor) {
    Optional<ClassNode> type = find(owner);
    if (type.isEmpty()) {
      return Optional.empty();
    }
    Optional<Declared> here = type.get().methods.stream()
        .filter(method -> method.name.equals(name) && method.desc.equals(descriptor)).findFirst()
        .map(method -> new Declared(type.get(), method));
    return here.or(() -> parents(type.get()).map(parent -> declared(parent, name, descriptor))
        .flatMap(Optional::stream).findFirst());
  }

  @Override
  public void close() throws IOException {
    for (ZipFile jar : jars) {
      jar.close();
    }
  }

  private static Stream<String> parents(ClassNode type) {
    return Stream.concat(Stream.ofNullable(type.superName), type.interfaces.stream());
  }

  /** Empty also for a class of a newer Java than ASM knows: what uses it stays as it is. */
  private Optional<ClassNode> read(String name) {
    try (InputStream content = open(name)) {
      if (content == null) {
        return Optional.empty();
      }
      byte[] bytes = content.readAllBytes();
      if (majorVersion(bytes) > NEWEST) {
        return Optional.empty();
      }
      ClassNode type = new ClassNode();
      new ClassReader(bytes).accept(type, ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG);
      return Optional.of(type);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static int majorVersion(byte[] type) {
    return ByteBuffer.wrap(type).getShort(6);
  }

  private InputStream open(String name) throws IOException {
    ZipFile jar = places.get(name);
    return jar == null
        ? ClassLoader.getPlatformClassLoader().getResourceAsStream(name + CLASS)
        : jar.getInputStream(jar.getEntry(name + CLASS));
  }

  /** A method, and the class that declares it. */
  record Declared(ClassNode type, MethodNode method) {}
}
