/**
 * Communication objects of SmartSoft, described in IDL: one text for each of SmartSoft's repositories
 * ({@code CommBasicObjects.idl}), which is a module with its structures. Those of common repositories are part of this
 * library; others are read from folders. Values are {@link org.robotui.message.DynamicMessage}.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.smartsoft.object;
