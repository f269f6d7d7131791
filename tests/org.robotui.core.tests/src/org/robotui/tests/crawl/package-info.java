/** A bundle that brings a transform for bridges; tests pack it. */
package org.robotui.tests.crawl;
