package org.robotui.architecture.tests;

import static java.util.stream.Collectors.toMap;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/** The syntax tree of a source, from the JDK's own parser: comments and strings cannot deceive it. */
record ParsedSource(CompilationUnitTree unit, Trees trees) {

  /** All in one run of the parser, as starting one takes longer than to read a file. */
  static Map<SourceFile, ParsedSource> of(List<SourceFile> sources) {
    Map<URI, SourceFile> files = sources.stream().collect(toMap(ParsedSource::address, source -> source));
    Map<SourceFile, ParsedSource> parsed = new HashMap<>();
    if (!sources.isEmpty()) {
      JavacTask task = (JavacTask) ToolProvider.getSystemJavaCompiler()
          .getTask(null, null, diagnostic -> {}, List.of("-proc:none"), null,
              sources.stream().map(ParsedSource::fileObject).toList());
      Trees trees = Trees.instance(task);
      units(task).forEach(unit -> parsed.put(files.get(unit.getSourceFile().toUri()), new ParsedSource(unit, trees)));
    }
    return parsed;
  }

  private static Iterable<? extends CompilationUnitTree> units(JavacTask task) {
    try {
      return task.parse();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  String packageName() {
    return unit.getPackageName() == null ? "" : unit.getPackageName().toString();
  }

  /** All qualified names in imports and code, as written. */
  Set<String> qualifiedNames() {
    Set<String> names = new TreeSet<>();
    new TreeScanner<Void, Void>() {
      @Override
      public Void visitImport(ImportTree node, Void none) {
        names.add(node.getQualifiedIdentifier().toString());
        return null;
      }

      @Override
      public Void visitMemberSelect(MemberSelectTree node, Void none) {
        Optional<String> name = name(node);
        name.ifPresent(names::add);
        return name.isPresent() ? null : super.visitMemberSelect(node, none);
      }
    }.scan(withoutPackage(), null);
    return names;
  }

  /** Empty where there is more than names, such as a call. */
  private static Optional<String> name(Tree tree) {
    return switch (tree) {
      case IdentifierTree one -> Optional.of(one.getName().toString());
      case MemberSelectTree select -> name(select.getExpression()).map(first -> first + "." + select.getIdentifier());
      default -> Optional.empty();
    };
  }

  private List<Tree> withoutPackage() {
    List<Tree> parts = new ArrayList<>(unit.getImports());
    parts.addAll(unit.getTypeDecls());
    return parts;
  }

  private static URI address(SourceFile source) {
    return URI.create("string:///" + source.where());
  }

  private static JavaFileObject fileObject(SourceFile source) {
    return new SimpleJavaFileObject(address(source), JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return source.text();
      }
    };
  }
}
