/**
 * Pictures of scenes, made by OpenGL beside the display thread. Everything of OpenGL happens on one thread that this
 * bundle owns; views ask for a picture and paint what comes.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.gl.render;
