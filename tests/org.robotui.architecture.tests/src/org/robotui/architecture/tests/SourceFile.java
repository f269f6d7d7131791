package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.List;

/** One Java file: where it lies under its source folder, and its text. */
record SourceFile(Path folder, Path path, String text) {

    static List<SourceFile> allIn(Path folder) {
        return Trees.files(folder, ".java").stream()
                .map(file -> new SourceFile(folder, file, Trees.read(file)))
                .toList();
    }

    /** The package that the folder stands for, as in "org.robotui.data". */
    String folderPackage() {
        Path parent = folder.relativize(path).getParent();
        return parent == null ? "" : parent.toString().replace('/', '.');
    }

    /** Bundle, source folder and path: what a reader needs to find it. */
    String where() {
        return folder.getParent().getParent().relativize(path).toString();
    }

    long lines() {
        return text.lines().count();
    }

    ParsedSource parsed() {
        return ParsedSource.of(this);
    }
}
